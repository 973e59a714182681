% SPDX-License-Identifier: GPL-3.0-or-later
% octave.m: a library of `torsor build`, called as docs/python.md says. The folder has cart.so and torsor_call.mex.
1;
function expect(holds, what)
  if ! holds
    error("not so: %s", what);
  end
end
function expect_refusal(words, varargin)
  try
    torsor_call(varargin{:});
  catch refusal
    expect(! isempty(strfind(refusal.message, words)), sprintf("'%s' in '%s'", words, refusal.message));
    return
  end
  error("nothing refuses what should be told '%s'", words);
end

cart = torsor_call("./cart.so");
expect(strcmp(cart.name, "cart_pole") && isequal(cart.coordinates, {"slide"; "hinge"}), "names");
expect(isequal(cart.coordinate_units, {"m"; "rad"}) && isequal(cart.input_units, {"N"; "N m"}), "units");
expect(isequal(cart.q, [0; 0.3]) && isequal(cart.v, [0; 0]) && cart.time == 0, "the start");
expect(isequal(cart.kernels(strcmp({cart.kernels.name}, "inverse_dynamics")).reads, {"accelerations"}), "what a kernel reads");

% Two kernels say the same of many states: M a + b = f, and accelerations of f are a.
q = [0.1 0.2 0.3 -0.4; 0.4 0.5 -0.6 2]; v = q - 1; a = q .^ 2;
f = torsor_call("./cart.so", "inverse_dynamics", q, v, "accelerations", a);
M = torsor_call("./cart.so", "mass_matrix", q, v);
b = torsor_call("./cart.so", "bias", q, v);
expect(isequal(size(f), [2 4]) && isequal(size(M), [2 2 4]), "sizes");
for s = 1:4
  expect(norm(M(:, :, s) * a(:, s) + b(:, s) - f(:, s)) < 1e-13, "M a + b = f");  % some roundings of numbers below 20
  alone = torsor_call("./cart.so", "inverse_dynamics", q(:, s), v(:, s), "accelerations", a(:, s));
  expect(isequal(alone, f(:, s)), "a state alone has the bits it has among others");
end
back = torsor_call("./cart.so", "forward_dynamics", q, v, "inputs", f, "threads", 2);
expect(norm(back - a) < 1e-12,  ...  % times the condition of M, below 10
        "accelerations of the forces that give them");
expect(isequal(torsor_call("./cart.so", "mass_matrix", q, v(:, 1)), M), "one column for all states");

% A motion is the same by two methods, and ends where Octave's own method says; energy changes by the power of the damper.
[y, reached] = torsor_call("./cart.so", "integrate", 0:0.01:1, [cart.q; cart.v], "tolerance", 1e-12, "method", "dormand_prince_853");
other = torsor_call("./cart.so", "integrate", [0.5 1], [cart.q; cart.v], "tolerance", 1e-12, "method", "taylor");
expect(reached == 1 && norm(other - y(:, [51 101])) < 1e-10, "two methods");  % some 30 steps of 1e-12 each
[T, U, power] = torsor_call("./cart.so", "energy", y(1:2, :), y(3:4, :));
simpson = 0.01 / 3 * (power(1) + power(end) + 4 * sum(power(2:2:end)) + 2 * sum(power(3:2:end-1)));
expect(abs(T(end) - U(end) - T(1) + U(1) - simpson) < 1e-6 * abs(simpson) && simpson < -1e-4, "energy");
slope = @(t, y) torsor_call("./cart.so", "state_derivative", y(1:2), y(3:4));
[t, path] = ode45(slope, [0 1], [cart.q; cart.v], odeset("RelTol", 1e-9, "AbsTol", 1e-9));
expect(norm(path(end, :)' - y(:, end)) < 1e-6,  ...  % some hundred steps of 1e-9
        "the end of ode45");

% What is not possible is told in words; a state that fails harms no other.
[M, status] = torsor_call("./cart.so", "mass_matrix", [NaN 0.2; 0 0.5], [0; 0]);
expect(isequal(status, [3 0]) && isequal(M(:, :, 2), torsor_call("./cart.so", "mass_matrix", [0.2; 0.5], [0; 0])), "statuses");
expect_refusal("not finite in 1 of 2 states", "./cart.so", "mass_matrix", [NaN 0.2; 0 0.5], [0; 0]);
expect_refusal("has no kernel 'masses'", "./cart.so", "masses", q, v);
expect_refusal("q has 1 rows, not 2", "./cart.so", "mass_matrix", q(1, :), v);
expect_refusal("v has 3 columns, where others have 4", "./cart.so", "mass_matrix", q, v(:, 1:3));
expect_refusal("real doubles", "./cart.so", "mass_matrix", single(q), v);
expect_refusal("reads accelerations", "./cart.so", "inverse_dynamics", q, v);
expect_refusal("no option 'acceleration'", "./cart.so", "inverse_dynamics", q, v, "acceleration", a);
expect_refusal("in pairs", "./cart.so", "inverse_dynamics", q, v, "accelerations");
expect_refusal("no method 'euler'", "./cart.so", "integrate", 1, [cart.q; cart.v], "method", "euler");
expect_refusal("the motion ends", "./cart.so", "integrate", 1, [cart.q; cart.v], "inputs", [1e308; 0]);
expect_refusal("nothing.so", "./nothing.so");
expect_refusal("full real", "./cart.so", "integrate", sparse([0 0 1]), [cart.q; cart.v]);
expect_refusal("one column", "./cart.so", "integrate", 1, [cart.q; cart.v], "inputs", [1 2; 0 0]);
expect_refusal("whole number", "./cart.so", "jets", q, v, "order", -2);
expect_refusal("takes no order", "./cart.so", "mass_matrix", q, v, "order", 2);
expect_refusal("begin with ./", "cart.so");
% No option is passed over.
start = [cart.q; cart.v];
expect_refusal("'inputs' is given twice", "./cart.so", "integrate", 1, start, "inputs", [1; 0], "inputs", [2; 0]);
expect_refusal("dormand_prince_54 chooses its own steps", "./cart.so", "integrate", 1, start, "step", 1e-3);
expect_refusal("reads no 'tolerance'", "./cart.so", "integrate", 1, start, "method", "midpoint", "step", 1e-3, "tolerance", 1e-9);
expect_refusal("runge_kutta_4 has a fixed step: give 'step'", "./cart.so", "integrate", 1, start, "method", "runge_kutta_4");
expect_refusal("mass_matrix does not read 'inputs'", "./cart.so", "mass_matrix", q, v, "inputs", f);
expect_refusal("jets takes 'order'", "./cart.so", "jets", q, v);
expect_refusal("status 2: unusable times", "./cart.so", "integrate", 1, start, "tolerance", -1);
expect_refusal("or a start that is not finite", "./cart.so", "integrate", 1, [NaN; start(2:end)]);

% Inputs and parameters of a motion: a force of 2 N on the cart, which by itself would stay, pushes it along.
pushed = torsor_call("./cart.so", "integrate", 0.1, [cart.q; cart.v], "inputs", [2; 0]);
still = torsor_call("./cart.so", "integrate", 0.1, [cart.q; cart.v]);
expect(pushed(1) - still(1) > 1e-3, "a force moves the cart");

% The pole has another mass, and none below zero.
expect(isequal(cart.parameters, {"pole_mass"}), "run-time parameters");
light = torsor_call("./cart.so", "mass_matrix", q(:, 1), v(:, 1), "parameters", 0.2);
heavy = torsor_call("./cart.so", "mass_matrix", q(:, 1), v(:, 1), "parameters", 0.4);
expect(abs(heavy(1, 1) - light(1, 1) - 0.2) < 1e-15 * 4, "a mass is set");
expect_refusal("body 'pole' has the mass pole_mass = -0.2 kg: a mass is never negative", "./cart.so", "mass_matrix", q, v, "parameters", -0.2);

% In another folder the same path is another library.
mkdir("other");
copyfile("cart.so", "other/rod.so");
here = cd("other");
expect_refusal("cannot open", "./cart.so");
expect(strcmp(torsor_call("./rod.so").name, "cart_pole"), "a path is that of the present folder");
cd(here);
clear torsor_call
expect(isequal(torsor_call("./cart.so").q, cart.q), "a library that is opened again");
printf("all of it holds\n");
