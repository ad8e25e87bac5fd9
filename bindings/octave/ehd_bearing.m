function result = ehd_bearing(case_name, varargin)
% EHD_BEARING  Balances one roller bearing with one contact force law (for Octave 7 and MATLAB).
%
%   b = ehd_bearing('na4908')                  law 'ehd': the film as solved
%   b = ehd_bearing('na4908', 'law', 'hertz')  dry
%
% Further pairs: an option of `ehd bearing` without its dashes, with _ for -, and its value.
%
% b  the JSON of `ehd bearing`: b.status, b.displacement_m, b.rollers(1).inner.force_N [N], ...
%
% SPDX-License-Identifier: GPL-3.0-or-later
  if ~any(strcmp(varargin(1:2:end), 'law'))
    varargin = [varargin, {'law', 'ehd'}];
  end
  result = ehd_run('bearing', ehd_words([{case_name}, varargin]));
end
