% SPDX-License-Identifier: GPL-3.0-or-later
% A deliberately simple solver of the line contact, to start your own from: the equations of line_contact.py for Octave
% 7 and later. Finite differences on an equal grid, Newton's method with a dense matrix.
%
%   octave-cli line_contact.m CASE.json OUT.json TOLERANCE     for ehd compare --external, {case} {out} {tolerance}
%
% The inlet has to be cut. Exit code: 0 the tolerance is met, 1 it is not, 2 the case cannot be read or is not for this
% program.
1;

function [eta, eta_P, rho, rho_P] = laws(problem, P, share)
  v = problem.viscosity; d = problem.density;
  eta = 0*P; eta_P = 0*P; rho = 1 + 0*P; rho_P = 0*P;
  if strcmp(v.law, 'barus')
    eta = share*v.alpha_p_H*P; eta_P = eta_P + share*v.alpha_p_H;
  elseif strcmp(v.law, 'roelands')
    a = share*v.alpha_p_H; p0 = v.p0_over_p_H;
    eta = a*p0/v.z*((1 + P/p0).^v.z - 1); eta_P = a*(1 + P/p0).^(v.z - 1);
  end
  if !strcmp(d.law, 'incompressible')
    rho = 1 + d.density_a*P./(1 + d.density_c*P); rho_P = d.density_a./(1 + d.density_c*P).^2;
  end
end

function v = upwind(v)  % on the faces: 1.5 v_i - 0.5 v_(i-1), the mean of two nodes on the first
  v = [(v(1, :) + v(2, :))/2; 1.5*v(2:end-1, :) - 0.5*v(1:end-2, :)];
end

function [P, H_0, H] = newton(X, P, H_0, lambda, share, problem)
  n = numel(X) - 1; h = X(2) - X(1);
  edge = ((-n:n+1)' - 0.5)*h;
  cell_integral = diff(edge.*log(abs(edge)) - edge);
  K = -toeplitz(cell_integral(n+1:end))/pi;
  for iteration = 1:60
    [eta, eta_P, rho, rho_P] = laws(problem, P, share);
    H = H_0 + X.^2/2 + K*P;
    f_P = rho.*K + diag(rho_P.*H);
    e = rho.*H.^3.*exp(-eta)/lambda;  % epsilon = rho H^3/(eta lambda)
    e_P = (3*e./H).*K + diag(e.*(rho_P./rho - eta_P));
    slope = diff(P)/h; mean_e = (e(2:end) + e(1:end-1))/2;
    q_P = slope.*(e_P(2:end, :) + e_P(1:end-1, :))/2 + mean_e.*diff(eye(n + 1))/h;
    q_0 = slope.*(3*e(2:end)./H(2:end) + 3*e(1:end-1)./H(1:end-1))/2;
    R = diff(mean_e.*slope - upwind(rho.*H));  % mass balance of nodes 2 ... n
    R_P = diff(q_P - upwind(f_P)); R_0 = diff(q_0 - upwind(rho));
    last = find(P(2:n) > 0, 1, 'last');  % of these equations; one more node joins if flow enters it
    if last < n - 1 && R(last + 1) > 0
      last = last + 1;
    end
    k = 1:last;
    A = [R_P(k, k + 1), R_0(k); h*ones(1, last), 0];
    step = -A \ [R(k); h*sum(P) - pi/2];
    largest = max(abs(step(k)));
    damping = min(1, 0.3/largest);
    P(k + 1) = P(k + 1) + damping*step(k);
    H_0 = H_0 + damping*step(end);
    P(last + 2:end) = 0;
    P(find(P < 0 & X > 0, 1):end) = 0;
    P = max(P, 0);
    if largest < 1e-9
      H = H_0 + X.^2/2 + K*P;
      return
    end
  end
  error('Newton''s method did not converge');
end

function both = films(X, H)  % the smallest one, by a parabola, and that at X = 0, by a cubic
  near = find(abs(X) < 1.3); [~, at] = min(H(near)); at = at + near(1) - 1;
  both = [H(at) - (H(at - 1) - H(at + 1))^2/(8*(H(at - 1) - 2*H(at) + H(at + 1))), 0];
  [~, order] = sort(abs(X)); four = order(1:4);
  both(2) = polyval(polyfit(X(four), H(four), 3), 0);
end

arguments = argv();
try
  text = fileread(arguments{end - 2});
  problem = jsondecode(text);
catch failure
  fputs(stderr, ["line_contact: the case " arguments{end - 2} " cannot be read: " failure.message "\n"]);
  exit(2);
end
id = regexp(text, '"case": *"([^"]*)"', 'tokens', 'once');  % jsondecode renames this key
out = arguments{end - 1}; tolerance = str2double(arguments{end});
if !isfield(problem, 'inlet') || ischar(problem.inlet)
  fputs(stderr, "line_contact: the inlet is not cut; required is a case with a number for its inlet\n");
  exit(2);
end
if !any(strcmp(problem.viscosity.law, {'isoviscous', 'barus', 'roelands'}))
  fputs(stderr, "line_contact: the viscosity law is unknown; required is isoviscous, barus or roelands\n");
  exit(2);
end
lambda = problem.groups.lambda; stated = 1; n = 128; P = [];
try
  while n <= 512 && stated > tolerance
    X = linspace(problem.inlet, 1.6, n + 1)';
    if isempty(P)
      P = sqrt(max(1 - X.^2, 0)); H_0 = 1; first = max(lambda, 0.5);
      for share = linspace(0, 1, 12)  % from a thick film of an oil without pressure dependence to the case
        [P, H_0, H] = newton(X, P, H_0, first*(lambda/first)^share, share, problem);
      end
    else
      [P, H_0, H] = newton(X, interp1(old, P, X), H_0, lambda, 1, problem);
      stated = min(1, max(abs(films(X, H)./now - 1)));
    end
    now = films(X, H); old = X; n = 2*n;
  end
catch failure  % the last line of standard error is what ehd compare shows
  fputs(stderr, ["line_contact: " failure.message "\n"]);
  exit(1);
end
file = fopen(out, 'w');
fprintf(file, ['{"schema": "ehd-submission-1", "solver": {"name": "line_contact.m", "version": "1"}, "results": [\n' ...
  ' {"case": "%s", "version": %d, "scaling": "hertz", "film.minimum": %.16g, "film.central": %.16g, ' ...
  '"stated_error": %.3g}]}\n'], id{1}, problem.version, now(1), now(2), stated);
fclose(file);
exit(double(!(stated <= tolerance)));
