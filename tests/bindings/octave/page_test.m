% The lines of bindings/octave/README.md, typed as they stand. Run by run.sh from the root of the tree.
% SPDX-License-Identifier: GPL-3.0-or-later
1;  % a script, although it begins with a function

function plot(x, y)
% Stands in for Octave's own, which needs a display.
  assert(numel(x) > 100 && isequal(size(x), size(y)));
end

lines = regexp(fileread('bindings/octave/README.md'), '^    (\S.*)$', 'tokens', 'lineanchors', 'dotexceptnewline');
assert(numel(lines) == 4);  % addpath, and one a function
for k = 1:numel(lines)
  eval(lines{k}{1});
end
assert(strcmp(r.status, 'converged') && b.rollers(1).inner.force_N > 0 && isequal(size(t.minimum), [1 3]));
