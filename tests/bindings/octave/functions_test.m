% The functions of bindings/octave against the program itself. Run by run.sh.
% SPDX-License-Identifier: GPL-3.0-or-later
1;  % a script, although it begins with a function

function yes = refused(work)
% True where the work ends with the program's one line.
  yes = false;
  try
    work();
  catch problem
    yes = strcmp(problem.identifier, 'ehd:input') && ~isempty(problem.message) && ~any(problem.message == 10);
  end
end

r = ehd_solve('M', 20, 'L', 10, 'tolerance', 1e-4);
[code, text] = system([getenv('EHD_PROGRAM') ' solve --M 20 --L 10 --tolerance 1e-4 --json -']);
direct = jsondecode(text);
assert(code == 0 && isequal(r.film, direct.film) && strcmp(r.status, 'converged'));
assert(r.film.minimum.error <= 1e-4);

% A case with an option; its fields from inlet to exit carry the load of Hertz' contact, and the smallest film.
steel = ehd_solve('own-steel-20-10', 'tolerance', 1e-4);
assert(strcmp(steel.xCase, 'own-steel-20-10') && steel.film.minimum.m > 0);
assert(all(diff(steel.X) > 0) && iscolumn(steel.X) && isequal(size(steel.X), size(steel.P), size(steel.H)));
assert(abs(trapz(steel.X, steel.P) / (pi / 2) - 1) < 1e-3);  % by trapezoids
assert(abs(min(steel.H) / steel.film.minimum.hertz - 1) < 1e-3);  % at the nodes

% Numbers with all their digits, and quotes in words.
oil = ehd_solve('M', 20, 'L', 10, 'viscosity', 'roelands', 'alpha_per_Pa', 2.2e-8, 'z', 0.68);
assert(oil.film.minimum.hertz ~= r.film.minimum.hertz);
assert(refused(@() ehd_solve('it''s; echo "no" case')));
assert(refused(@() ehd_solve('M', -1, 'L', 10)));
assert(refused(@() ehd_bearing('na4908', 'law', 'hooke')));

% What makes no word of a command line: numbers without their names, a lost value, and what is not one number.
assert(refused(@() ehd_solve(20, 10)));
assert(refused(@() ehd_solve(20)));
assert(refused(@() ehd_solve('M', 20, 'L')));
for wrong = {[20 30], [], 20i, {20}, true, struct()}
  assert(refused(@() ehd_solve('M', wrong{1}, 'L', 10)));
end
assert(refused(@() ehd_bearing(4908)));
assert(refused(@() ehd_films(20, 10, 'tolerance', [1e-3 1e-4])));

% What did not converge comes back.
loose = ehd_solve('M', 20, 'L', 10, 'nodes', 16);
assert(strcmp(loose.status, 'under-resolved'));

t = ehd_films([5 50; 20 500], 10, 'tolerance', 1e-4);
assert(isequal(size(t.minimum), [2 2]) && t.minimum(2, 1) == r.film.minimum.hertz);
assert(t.central_error(2, 1) == r.film.central.error && all(strcmp(t.status(:), 'converged')));

b = ehd_bearing('na4908', 'law', 'hertz');
assert(numel(b.rollers) == 22 && strcmp(b.law, 'hertz') && b.rollers(1).inner.force_N > 9000);
assert(strcmp(ehd_bearing('na4908').law, 'ehd'));
disp('octave: all right');
