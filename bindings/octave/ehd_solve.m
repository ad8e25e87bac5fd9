function result = ehd_solve(varargin)
% EHD_SOLVE  Solves one elastohydrodynamic line contact (for Octave 7 and MATLAB).
%
%   r = ehd_solve('own-moes-20-10')                    a benchmark case
%   r = ehd_solve('my-contact.toml', 'tolerance', 1e-4)
%   r = ehd_solve('M', 20, 'L', 10)                    Barus, incompressible, fully flooded
%   r = ehd_solve('M', 20, 'L', 10, 'viscosity', 'roelands', 'alpha_per_Pa', 2.2e-8, 'z', 0.68)
%
% Behind a case, or alone: pairs of an option of `ehd solve` without its dashes, with _ for -, and its value.
%
% r  the JSON of `ehd solve`: r.status, r.film.minimum.hertz (H = h R/b^2), r.film.minimum.m (metres, where SI is
%    known), r.film.minimum.error (relative), ...; the id of the case is r.xCase, because case is a word of the
%    language.
%    Where there is a solution also its fields as columns, from inlet to exit: r.X = x/b, r.P = p/p_H, r.H.
%
% SPDX-License-Identifier: GPL-3.0-or-later
  profile = [tempname() '.csv'];
  words = [ehd_words(varargin), {'--profile', profile}];
  result = ehd_run('solve', words);
  if exist(profile, 'file') ~= 2
    return;
  end
  fields = dlmread(profile, ',', 1, 0);
  delete(profile);
  result.X = fields(:, 1);
  result.P = fields(:, 2);
  result.H = fields(:, 3);
end
