function films = ehd_films(M, L, varargin)
% EHD_FILMS  The films of several contacts with one lubricant (for Octave 7 and MATLAB).
%
%   t = ehd_films([5 50 500], 10, 'tolerance', 1e-4)
%
% M, L  Moes' groups, with the sum speed; arrays of one size, or one number and an array. Further pairs: as for
%       ehd_solve.
%
% t  arrays of that size: t.minimum, t.central (H = h R/b^2), t.minimum_error, t.central_error (relative), and
%    t.status, a cell of texts. NaN where there is no film.
%
% The program runs once a contact, in about 25 ms. For thousands of contacts take `ehd sweep`, or Python's ehd.films.
% SPDX-License-Identifier: GPL-3.0-or-later
  [M, L] = deal(M + 0 * L, L + 0 * M);
  films = struct('M', M, 'L', L, 'minimum', NaN(size(M)), 'minimum_error', NaN(size(M)), ...
                 'central', NaN(size(M)), 'central_error', NaN(size(M)), 'status', {cell(size(M))});
  for k = 1:numel(M)
    result = ehd_run('solve', ehd_words([{'M', M(k), 'L', L(k)}, varargin]));
    films.status{k} = result.status;
    for film = {'minimum', 'central'}
      if isfield(result, 'film') && isfield(result.film, film{1})
        films.(film{1})(k) = result.film.(film{1}).hertz;
        films.([film{1} '_error'])(k) = result.film.(film{1}).error;
      end
    end
  end
end
