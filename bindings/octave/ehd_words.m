function words = ehd_words(arguments)
% EHD_WORDS  The words of a command line: a case, where the number of arguments is odd, then pairs of option and value.
%
%   ehd_words({'na4908', 'law', 'ehd'})     {'na4908', '--law', 'ehd'}
%
% An option is written without its dashes, with _ for -: 'alpha_per_Pa' is --alpha-per-Pa.
% SPDX-License-Identifier: GPL-3.0-or-later
  words = {};
  if mod(numel(arguments), 2) == 1
    words = arguments(1);
    arguments = arguments(2:end);
  end
  for k = 1:2:numel(arguments)
    words = [words, {['--' strrep(arguments{k}, '_', '-')], arguments{k + 1}}]; %#ok<AGROW>
  end
end
