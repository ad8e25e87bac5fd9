function words = ehd_words(arguments)
% EHD_WORDS  The words of a command line: a case, where the number of arguments is odd, then pairs of option and value.
%
%   ehd_words({'na4908', 'law', 'ehd'})     {'na4908', '--law', 'ehd'}
%
% An option is written without its dashes, with _ for -: 'alpha_per_Pa' is --alpha-per-Pa. What is no text where a case
% or an option stands, and what is neither one number nor a text where a value stands, is the error 'ehd:input'.
% SPDX-License-Identifier: GPL-3.0-or-later
  words = {};
  if mod(numel(arguments), 2) == 1
    words = arguments(1);
    arguments = arguments(2:end);
    if ~ischar(words{1})
      error('ehd:input', 'the case is no text; allowed is a path or an id, or pairs such as ''M'', 20, ''L'', 10');
    end
  end
  for k = 1:2:numel(arguments)
    [option, value] = arguments{k:k + 1};
    if ~ischar(option)
      error('ehd:input', 'an option is no text; allowed are pairs such as ''M'', 20, ''L'', 10');
    end
    if ~ischar(value) && ~(isnumeric(value) && isreal(value) && isscalar(value))
      error('ehd:input', '%s: is neither one number nor a text; allowed is one of them', option);
    end
    words = [words, {['--' strrep(option, '_', '-')], value}]; %#ok<AGROW>
  end
end
