/* SPDX-License-Identifier: MIT */
/* Many solves: how do velocity and jerk trade? Rows come as they are solved; an argument says how many are
 * enough. */
#include <camopt.h>
#include <stdio.h>
#include <stdlib.h>

static const char scene_text[] =
    "[motion]\n"
    "type = \"DRD\"\n"
    "lift_mm = 10\n"
    "rise_deg = 120\n"
    "[spline]\n"
    "segments = 12\n"
    "[objective]\n"
    "velocity = 1\n"
    "acceleration = 0.5\n";

typedef struct {
    size_t seen, enough;
    size_t lines; /* of progress */
} watcher;

static int take_row(const camopt_sweep_row* row, void* user) {
    watcher* watch = (watcher*)user;
    printf("row %zu of %zu: jerk weight %.2f  %-8s  V %.5f  A %.5f  J %.4f\n", row->number + 1, row->rows,
           row->settings[0], camopt_verdict_name(row->verdict), row->velocity, row->acceleration, row->jerk);
    return ++watch->seen >= watch->enough;
}

static void take_progress(const camopt_progress* progress, void* user) {
    watcher* watch = (watcher*)user;
    if (progress->message[0] != '\0' && progress->seconds >= 0.0) ++watch->lines;
}

static int is_cancelled(void* user) {
    (void)user; /* a program with windows looks at its button here */
    return 0;
}

int main(int count, char** arguments) {
    const char* const keys[] = {"objective.jerk"};
    double weights[21];
    camopt_sweep_axis axis;
    camopt_solve_options options = {0};
    camopt_scene* scene = NULL;
    camopt_error code;
    watcher watch = {0, 0, 0};
    size_t i;

    watch.enough = count > 1 ? strtoul(arguments[1], NULL, 10) : 21;
    for (i = 0; i < 21; ++i) weights[i] = 0.05 * (double)i;
    axis.keys = keys;
    axis.key_count = 1;
    axis.values = weights;
    axis.point_count = 21;
    options.size = sizeof options;
    options.progress = take_progress;
    options.cancel = is_cancelled;
    options.user = &watch;

    code = camopt_scene_from_toml(scene_text, "sweep", &scene);
    if (code == CAMOPT_OK) code = camopt_sweep(scene, &axis, 1, &options, take_row, &watch);
    camopt_scene_free(scene);
    if (code != CAMOPT_OK && code != CAMOPT_ERROR_CANCELLED) {
        fprintf(stderr, "%s: %s\n", camopt_error_name(code), camopt_error_text());
        return 1;
    }
    printf("%s after %zu rows, %s\n", camopt_error_name(code), watch.seen,
           watch.lines > 0 ? "progress was told" : "without progress");
    return 0;
}
