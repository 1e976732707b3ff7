# SPDX-License-Identifier: MIT
# The headers that are promised to embedders (docs/embedding.md), one row each: its name, what it is for, and the headers of
# the tree that it brings. Writes camopt/NAME.hpp of each, and camopt/camopt.hpp of all, into camopt_promised_dir; a script
# too: cmake -Dcamopt_promised_dir=DIR -P include/promised_headers.cmake.
set(camopt_promised "")

# camopt_write_promised(<name> <comment> <headers …>): sorted as clang-format sorts them.
function(camopt_write_promised name comment)
  string(REPLACE "\n" "\n// " comment "// ${comment}")
  string(REPLACE "// \n" "//\n" comment "${comment}")
  set(headers ${ARGN} core/language.hpp)
  list(SORT headers)
  list(JOIN headers "\"\n#include \"" includes)
  file(CONFIGURE OUTPUT "${camopt_promised_dir}/camopt/${name}.hpp" @ONLY CONTENT
    "// SPDX-License-Identifier: MIT\n${comment}\n#pragma once\n\n#include \"${includes}\"\n")
endfunction()

# Of a build without the shop what is left of it.
macro(camopt_promise name comment)
  set(camopt_kept ${ARGN})
  if(DEFINED CAMOPT_SHOP AND NOT CAMOPT_SHOP)
    list(FILTER camopt_kept EXCLUDE REGEX "^shop/")
  endif()
  if(camopt_kept)
    camopt_write_promised(${name} "${comment}" ${camopt_kept})
    list(APPEND camopt_promised camopt/${name}.hpp)
  endif()
endmacro()

camopt_promise(adjustments [[
What a user could change about a scene without a motion, one number at a time, and the search for the
least change of each (explain(solution, control); solve() does it already where it finds nothing).]]
  studies/explain/explain.hpp
  studies/least/adjustment.hpp)
camopt_promise(any_curve_limit [[
The limit that no curve can pass: any_curve_limit(input) is the least wV V + wA A + wJ J over all motions
of bounded jerk, regardless of their shape. Peaks without units. Errors: InputError for weights that are
negative or all zero.]]
  motions/bounds/any_curve_limit.hpp)
camopt_promise(cam_kinds [[
The kinds of cams a scene file can name, and one of your own beside them: add_cam_kind() with a CamKind
that describes its keys and makes its formulas (camopt/mechanism.hpp).]]
  profiles/kinds/cam_kinds.hpp)
camopt_promise(cam_points [[
A whole cam as points: sampled_profile(cam, motion, scale, sampling), with s = lift · y and θ = unit_angle
· x. Points are placed closer where the cam bends. m, rad.]]
  profiles/sampling.hpp)
camopt_promise(cam_spec [[
The cam of a scene, of any kind (type, choices, dimensions, rotation; disk_cam.hpp, remote_cam.hpp,
spatial_cam.hpp, inverse_cam.hpp, linear_cam.hpp make one each), and what its follower carries. m, rad, kg, N.]]
  scene/cam_spec.hpp)
camopt_promise(certificate [[
What was found, and the proof of it. For any multipliers λ and a box [l, u] that holds an optimum

  f* >= constant − Σ λ_i b_i + Σ min(r_j l_j, r_j u_j),   r = c + Gᵀλ,

so a proof is a list of numbers; recomputed_bound(proof) computes the bound from them again. Objectives
are without units. Nothing throws.]]
  solvers/certificate/certificate.hpp)
camopt_promise(comparison [[
Every classical law on one scene beside the optimum: what each loses, which limits it breaks, how large
its cam would have to be. Units as in Solution; infinite peaks are infinite. Throws as solve() does.
comparison_document() is what there is to say of it: console_text(), document_json() and others write it.]]
  report/compare/comparison_document.hpp
  report/document/document_text.hpp
  studies/compare/comparison.hpp)
camopt_promise(continuous_problem [[
The problem behind the grid: constraints that hold at every cam angle. Derive from ContinuousProblem to
have a problem of your own solved by exchange (grid, true maxima, new rows) and judged. One belongs to one
thread at a time.]]
  core/continuous_problem.hpp
  solvers/exchange/exchange.hpp)
camopt_promise(deadline [[
Until when: one value for everything done under one limit of time. Copies share whether it was ever felt.
Seconds. Safe to ask from several threads.]]
  core/deadline.hpp)
camopt_promise(disk_cam [[
Disk cams: scene.cam = disk_spec({.follower = …}) puts one into a scene. One point of the follower's motion
makes one point of the cam (profile_point), and the quantities that limits are made of (pressure angle,
radii, forces) with exact partials. Frames and signs stand in the header this one brings; m, rad, s' in
m/rad. disk_cam(solution.cam->cam) is the one that was delivered.]]
  profiles/disk/disk_cam.hpp)
camopt_promise(drawings [[
Cams as DXF text: arcs within a tolerance (m) of the exact curve; files in mm. Errors: InputError for a
tolerance that is not positive and a cam that is not finite.]]
  shop/dxf/cam_dxf.hpp
  report/cam/cam_files.hpp)
camopt_promise(errors [[
The exceptions camopt throws: InputError (something the caller gave is wrong; the message says what was
found and what is allowed), UnavailableError (an InputError: this build lacks what was asked for),
ModelError (a broken model, a fault of who implements an interface). Numerical outcomes are enums, never
exceptions.]]
  core/errors.hpp)
camopt_promise(exports [[
The files of a solved scene by their names, in memory or in a folder: exported_file(solution, "cam.nc"),
write_exports(folder, solution, names). NC programs with their check, STEP and STL, workshop drawings (PDF,
SVG, DXF), electronic cams for controllers, reports. Options by their key, {"cutter_mm", "12"}; files in mm
and degrees. Errors: InputError, UnavailableError for STEP or PDF in a build without the library.]]
  report/exports/exports.hpp)
camopt_promise(extrema [[
Exact extrema of piecewise polynomials and the peaks of a spline curve: every end of a segment from both
sides, every stationary point inside. No sampling. No units.]]
  splines/curve.hpp)
camopt_promise(forward_check [[
The finished cam turned under its follower, by its points alone: does the follower move as designed?
checked_cam(solution) for a solved scene with a cam of any kind, forward_check(input) for points of any
origin. m, rad.]]
  studies/check/check_cam.hpp
  studies/check/forward_check.hpp
  studies/checked/checked_cam.hpp)
camopt_promise(inverse_cam [[
Inverse cams: scene.cam = inverse_spec() with its numbers puts one into a scene, whose guide makes the
feeder move as its motion says; and the check that pushes a roller through the finished guide. m, rad, s.]]
  profiles/inverse/inverse_mechanism.hpp
  studies/inverse/inverse_forward.hpp)
camopt_promise(law_losses [[
Where each classical law lies above the trade-off of V, A and J of a scene: its least loss over all
weights,

  loss(w) = f_law(w) / f_optimum(w) − 1.]]
  studies/compare/law_losses.hpp)
camopt_promise(laws [[
The classical motion laws as Motions with closed-form derivatives and exact peaks: law_catalogue() lists
them, make_law("modified_sine") or make_law("modified_sine(Ta = 0.2)") makes one.

  y(0) = 0, y(1) = 1, y'(0) = y'(1) = 0 on 0 <= x <= 1.

Infinite peaks are impulses. Errors: InputError for an unknown key or a parameter out of range.]]
  motions/laws/law_catalogue.hpp
  motions/laws/harmonic_law.hpp)
camopt_promise(licenses [[
Which libraries of others are in this build, and under what terms a binary of it may be passed on:
licensed_parts(), terms_of_binary().]]
  core/version.hpp)
camopt_promise(linear_cam [[
Linear (plate) cams: scene.cam = linear_spec(follower) with its numbers puts a plate that slides under a
roller, an edge or an arm into a scene. m, rad.]]
  profiles/linear/linear_mechanism.hpp)
camopt_promise(machine [[
A machine of several axes on one master, with clearances between them: solve_machine(machine) finds the
largest speed at which motions exist, or the least total objective at a given one, with the proof;
input::read_machine reads a machine file. SI and radians. Throws InputError and SceneError as solve() does.]]
  input/machine/machine_reader.hpp
  scene/machine_spec.hpp
  studies/machine/machine.hpp)
camopt_promise(mechanism [[
Any mechanism between a cam and its output, as the optimizer sees it: from one state (s, s', s'') of the
output and the mechanism's dimensions to the quantities that limits are made of, with exact partials.
scene.cam is the cam of a scene, of any kind. Implement CamMechanism to bring one of your own. m,
rad, s' and s'' by the cam angle. Out of reach is NaN, never a throw; calls are const and may come from
several threads at once.]]
  scene/cam_mechanism.hpp
  studies/delivered/driven_mechanism.hpp)
camopt_promise(motion [[
A motion y(x) with its first three derivatives, and its peaks.

  x = cam angle / rise angle, y = displacement / lift, ' is d/dx; no units.
  V = max |y'|, A = max |y''|, J = max |y'''|.

Motion::at(x, side) gives a MotionPoint; outside [begin(), end()] it throws InputError. A Motion is never
written to by a const call: threads may share one.]]
  core/numbers/extremum.hpp
  core/motion.hpp)
camopt_promise(motion_chain [[
Motions one after another as one Motion: a whole turn of dwells, laws and splines.

  y(x) = y0 + y_scale · shape((x − x0) / x_scale) on each part.]]
  splines/motion_chain.hpp)
camopt_promise(nc [[
NC programs with their check: machines as pure kinematics, post-processors as data, paths cut into blocks,
printed, read back, and run against points of the wanted surface. m, rad, s inside, the program's units in
the text. A program whose check fails is to be kept from machines: look at CheckedProgram before writing
one.]]
  shop/disk/disk_export.hpp
  shop/nc/checked_program.hpp
  shop/nc/machine.hpp
  shop/nc/post_processor.hpp
  shop/spatial/cam_export.hpp)
camopt_promise(nlp [[
The optimization problem a backend sees:

  min f(x)   subject to   x_L <= x <= x_U,   g_L <= g(x) <= g_U.

x has `variables` entries, g `constraints` rows; missing bounds are ±infinity. L = σ f + λᵀ g, λ > 0 at an
active upper bound. Derive from Nlp to bring a problem of your own; derivative_errors (scene_check.hpp)
compares its derivatives with differences. An Nlp may keep work space between calls: one belongs to one
thread at a time.]]
  core/nlp.hpp)
camopt_promise(own_rules [[
Cost terms and limits of your own, for Scene::own_terms and Scene::own_limits: any function of y to y'''.]]
  scene/own_rule.hpp)
camopt_promise(pareto_front [[
The trade-off of two figures of a scene, traced by limits instead of weights: min p + ε q subject to q <=
cap. Also the front over the rows of a sweep.]]
  studies/pareto/pareto_front.hpp
  studies/pareto/sweep_front.hpp)
camopt_promise(pictures [[
Motion, cam and mechanism as SVG text, to scale where they show a machine.]]
  report/chart/curve_chart.hpp
  report/drawing/cam_svg.hpp)
camopt_promise(reference_table [[
The published spline-versus-modified-sine tables beside what is true. Peaks without units.]]
  report/papers/paper_output.hpp
  studies/papers/reference_table.hpp)
camopt_promise(remote_cam [[
Disk cams whose roller lever moves the output through a linkage: positions, pressure angle and radii by
closed forms, dyad by dyad, from the output back to the cam. m, rad.]]
  profiles/remote/remote_cam.hpp)
camopt_promise(result_folder [[
A solution as files (report, table of the motion, proof, pictures, profile), and read back without solving
(read_result_folder). Files of an earlier run are replaced together. Display units (mm, degrees). Errors:
InputError naming the folder or file, and what does not fit.]]
  report/folders/result_folder_reader.hpp)
camopt_promise(result_json [[
result.json, and certificate.json with the recipe by which anybody can recompute the bound, also read back
(read_certificate). Display units in result.json; the certificate is in the units of its problem. Errors:
InputError for a file that is not a certificate.]]
  report/json/certificate_json.hpp
  report/json/result_json.hpp)
camopt_promise(scene [[
A scene: what must move, what counts, which limits hold, how fine the spline may be, and the cam. Plain
values in SI and radians with the defaults of a scene file. find_fault(scene) says what is wrong with one;
validate(scene) throws InputError with it. Every study validates what it is given.

Scenes may be copied and read by several threads.]]
  scene/scene.hpp
  scene/key_row.hpp)
camopt_promise(scene_check [[
What can be said of a scene without solving it: which problem it becomes, how large it is, which verdict
can come, and whether its derivatives agree with differences. Throws InputError for a wrong scene.]]
  studies/check/scene_check.hpp)
camopt_promise(scene_file [[
Scene files: TOML in, Scene out, ready to be solved: load_scene(file), scene_of_toml(text). Behind them the
reader itself (input::read_scene_file, input::read_scene), scenes made key by key (input::SceneDocument),
any scene as a file (input::scene_text), and every key such a file may have (input::scene_keys) with its
type, unit, range and default. Files are in the unit of the key, scenes in SI. Errors: InputError "FILE:LINE:COLUMN: key: found …; allowed: …".]]
  input/scene_document.hpp
  input/keys/scene_keys.hpp
  input/loading/load_scene.hpp
  input/scene_reader.hpp
  input/scene_text.hpp)
camopt_promise(smallest_cam [[
The least prime radius with which any motion at all can keep a pressure angle:

  s0 >= h / (exp(β tan φ) − 1) − σ e / tan φ   for a stroke of cam angle β, lift h, offset e.

m, rad. Errors: InputError for numbers out of range.]]
  motions/bounds/smallest_cam.hpp)
camopt_promise(solution [[
Everything known after a scene was solved: the motion, its peaks, limits and what they leave, the cam,
what would help where nothing was found, the certificate. SI and radians; peaks without units. A Solution
is a value: copies share their motions, which are constant.]]
  studies/delivered/solution.hpp)
camopt_promise(solve [[
A scene goes in; the best motion comes out, with its exact peaks, the cam and the proof: solve(scene,
control). plan(scene) says what solve() will do, without a solve.

Throws InputError for a wrong scene, UnavailableError for a backend this build leaves out. Every numerical
outcome is a Verdict. Threads may solve at once, the same scene too; Ipopt's turns are taken one after
another, all else runs side by side.]]
  scene/written_limits.hpp
  studies/solve/solve.hpp)
camopt_promise(solver [[
A backend: takes an Nlp and a start, hands back a point, perhaps multipliers, and why it stopped
(Termination). It judges nothing; certificate.hpp does. SolveControl carries the limits of time and a stop
request, which may be set by another thread. A Solver belongs to one thread at a time.]]
  solvers/solver.hpp)
camopt_promise(solver_registry [[
Which backends there are, which of them this build has, and the options each takes: solver_entries(),
make_solver(name). A backend that this build leaves out throws UnavailableError naming the package. The
registry is constant.]]
  solvers/registry.hpp)
camopt_promise(spatial_cam [[
Barrel and cylindrical cams with a cylindrical roller: the roller's axis, contact on both flanks, pressure
angle, undercut, and the flanks as grids of points. m, rad.]]
  scene/cam_flanks.hpp
  profiles/spatial/spatial_cam.hpp)
camopt_promise(spline_curve [[
Piecewise polynomial motions y(x) of degree p with continuity C^k: on segment i, t = x − x_i, y = Σ
a_{i,m} t^m. SplineCurve takes the coefficients as a matrix, one column a segment, one row a power; hands
out its clamped B-spline form. No units. Outside the breakpoints: InputError.]]
  splines/curve.hpp)
camopt_promise(surfaces [[
Flanks and solids of cams as STL and (where this build has Open CASCADE: step_available()) STEP. m
inside, mm in files. Errors: UnavailableError for STEP in a build without it.]]
  shop/spatial/cam_export.hpp
  report/surface/triangle_mesh.hpp
  shop/step/step_file.hpp)
camopt_promise(sweep [[
Many solves as one table: which keys of a scene vary (SweepAxis), the rows in an order of neighbours
(SweepPlan), a chunk of rows solved in order (solve_chunk). Values of axes are in the unit of their key. A
row depends on the plan and on the size of its chunk, never on who solved it: chunks may be solved by
several threads, each with its own SweepScenes. Or a function sets what varies: sweep(scene, values,
set).]]
  studies/sweep/sweep_axis.hpp
  studies/sweep/sweep_plan.hpp
  studies/sweep/sweep_row.hpp
  studies/sweep/sweep_run.hpp)
camopt_promise(tables [[
Motion and cam as CSV text: a header line, a point a row, display units, "." as decimal sign regardless of the
locale.]]
  report/csv/motion_csv.hpp)
camopt_promise(train_formulas [[
From the elastic follower train of a scene to its formulas: complete_dynamics(scene), once, before a scene
built in C++ is solved. Throws InputError for a chain of more than four masses.]]
  dynamics/train_formulas.hpp)
camopt_promise(train_study [[
A motion, laws and a rigid optimum on the elastic train of a scene: residuals and forces over the speed, what is
left where the natural frequency is another. Lifts, rad/s.]]
  studies/response/train_study.hpp)
camopt_promise(units [[
Factors from display units to SI: 3.0 * units::millimetre is 0.003 m, 90 * units::degree is π/2 rad.
Everything behind these headers is in m, rad, s, kg, N unless its comment says otherwise.]]
  core/units.hpp)
camopt_promise(valves [[
Valve lobes: ValveSpec and make_valve_lobe() for the motion of a scene; of a solved lobe its events,
durations, areas, accelerations and spring (valve_report), of two the overlap (valve_pair). m, rad, N.
lobe_csv() writes the table for engine programs.]]
  report/csv/lobe_csv.hpp
  scene/valve_spec.hpp
  studies/valve/valve_report.hpp)
camopt_promise(version [[
The version of this camopt, "MAJOR.MINOR.PATCH".]]
  core/version.hpp)
camopt_promise(words [[
A solution and a sweep in words: the verdict in a sentence, limits, what would help. UTF-8, display units.
Nothing throws.]]
  report/solve/solution_document.hpp
  report/sweep/sweep_document.hpp
  report/solve/infeasible_words.hpp
  report/view/verdict_words.hpp)
camopt_promise(camopt [[
Everything an embedder calls. Each header below is a promise by itself: its names stay as they are within a
minor version. What stands below camopt/detail/ is what they are made of, and may change with every
version.]]
  ${camopt_promised})
