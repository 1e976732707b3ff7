/* SPDX-License-Identifier: MIT */
/* A first solve: a scene key by key, the best motion, its proof, a table of it. */
#include <camopt.h>
#include <stdio.h>
#include <stdlib.h>

static void must(camopt_error code) {
    if (code == CAMOPT_OK) return;
    fprintf(stderr, "%s: %s\n", camopt_error_name(code), camopt_error_text());
    exit(1);
}

int main(void) {
    camopt_scene* scene = NULL;
    camopt_solution* solution = NULL;
    camopt_summary summary;
    camopt_peaks peaks;
    double x[5], y[5], velocity[5];
    size_t i;

    if (camopt_abi_version() != CAMOPT_ABI_VERSION) return 2;
    must(camopt_scene_new(&scene));
    must(camopt_set_text(scene, "motion.type", "DRD"));
    must(camopt_set_number(scene, "motion.lift_mm", 10));
    must(camopt_set_number(scene, "motion.rise_deg", 120));
    must(camopt_set_number(scene, "spline.segments", 12));
    must(camopt_set_number(scene, "objective.velocity", 0.4));
    must(camopt_set_number(scene, "objective.acceleration", 0.4));
    must(camopt_set_number(scene, "objective.jerk", 0.2));

    /* A wrong value is told at once, and changes nothing. */
    if (camopt_set_number(scene, "spline.degree", 4) != CAMOPT_ERROR_INPUT) return 3;
    printf("refused: %s\n", camopt_error_text());

    must(camopt_solve(scene, NULL, &solution));
    camopt_scene_free(scene);

    summary.size = sizeof summary;
    must(camopt_solution_summary(solution, &summary));
    printf("%s: objective %.8f, proved bound %.8f\n", camopt_verdict_name(summary.verdict), summary.objective,
           summary.lower_bound);
    if (!summary.has_motion) return 4;

    peaks.size = sizeof peaks;
    must(camopt_solution_peaks(solution, &peaks));
    printf("V %.6f  A %.6f  J %.6f\n", peaks.velocity, peaks.acceleration, peaks.jerk);

    must(camopt_motion_samples(solution, 5, x, y, velocity, NULL, NULL));
    for (i = 0; i < 5; ++i)
        printf("%6.1f deg  %8.5f mm  %8.5f mm/deg\n", x[i] * summary.rise_deg, y[i] * summary.lift,
               velocity[i] * summary.lift / summary.rise_deg);
    camopt_solution_free(solution);
    return 0;
}
