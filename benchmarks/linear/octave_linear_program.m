% SPDX-License-Identifier: MIT
% octave_linear_program.m PROGRAM METHOD REPEATS POINT: one linear program (linear_program_text.hpp) solved by
% Octave: METHOD is glpk-simplex, glpk-dual, glpk-dual-plain
% (no presolve), glpk-interior or sqp. Writes the point to POINT, one number a line; prints
% status, iterations (0 where unknown) and the seconds of each call.
function octave_linear_program(words)
  numbers = fscanf(fopen(words{1}), "%g");
  n = numbers(1); m = numbers(2); k = numbers(3);
  columns = reshape(numbers(5:4 + 3 * n), 3, n)';
  rows = reshape(numbers(5 + 3 * n:4 + 3 * n + 3 * m), 3, m)';
  entries = reshape(numbers(5 + 3 * (n + m):4 + 3 * (n + m + k)), 3, k)';
  a = sparse(entries(:, 1) + 1, entries(:, 2) + 1, entries(:, 3), m, n);
  equal = rows(:, 1) == rows(:, 2);
  upper = ! equal & isfinite(rows(:, 2));
  lower = ! equal & isfinite(rows(:, 1));
  c = columns(:, 1);
  seconds = [];
  for repeat = 1:str2double(words{3})
    if strcmp(words{2}, "sqp")
      tic;
      [x, status, iterations] = by_sqp(c, columns, a, rows, equal, upper, lower);
    else
      tic;
      [x, status, iterations] = by_glpk(c, columns, a, rows, equal, upper, lower, words{2});
    end
    seconds(end + 1) = toc;
    if sum(seconds) > 4
      break;
    end
  end
  file = fopen(words{4}, "w");
  fprintf(file, "%.17g\n", x);
  fclose(file);
  printf("%d %d%s\n", status, iterations, sprintf(" %.9g", seconds));
end

function [x, status, iterations] = by_glpk(c, columns, a, rows, equal, upper, lower, method)
  matrix = [a(equal, :); a(upper, :); a(lower, :)];
  sides = [rows(equal, 1); rows(upper, 2); rows(lower, 1)];
  kinds = [repmat("S", 1, sum(equal)), repmat("U", 1, sum(upper)), repmat("L", 1, sum(lower))];
  options.msglev = 0;
  options.tolbnd = options.toldj = 1e-9;
  options.tmlim = 10000; % ms, whatever the manual says
  options.presol = ! strcmp(method, "glpk-dual-plain");
  options.lpsolver = 1 + strcmp(method, "glpk-interior");
  if strncmp(method, "glpk-dual", 9)
    options.dual = 2;
  end
  kind_of_variables = repmat("C", 1, numel(c));
  [x, value, code, extra] = glpk(c, matrix, sides, columns(:, 2), columns(:, 3), kinds, kind_of_variables, 1, options);
  status = extra.status;
  iterations = 0;
end

function [x, status, iterations] = by_sqp(c, columns, a, rows, equal, upper, lower)
  cost = {@(x) c' * x, @(x) c, @(x) zeros(numel(c))};
  full_a = full(a);
  equalities = {@(x) full_a(equal, :) * x - rows(equal, 1), @(x) full_a(equal, :)};
  inside = [-full_a(upper, :); full_a(lower, :)];
  sides = [rows(upper, 2); -rows(lower, 1)];
  inequalities = {@(x) inside * x + sides, @(x) inside};
  if ! any(equal)
    equalities = [];
  end
  [x, value, status, iterations] = sqp(zeros(numel(c), 1), cost, equalities, inequalities, columns(:, 2), ...
                                       columns(:, 3), 200, 1e-10);
end

crash_dumps_octave_core(false);
warning("off", "all");
octave_linear_program(argv());
