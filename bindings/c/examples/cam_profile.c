/* SPDX-License-Identifier: MIT */
/* Motion and cam together: the limits as kept, the cam's points, its drawing in memory. With an argument the
 * drawing goes to that file. */
#include <camopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char scene_text[] =
    "[motion]\n"
    "type = \"RR\"\n"
    "lift_mm = 20\n"
    "rise_deg = 80\n"
    "return_deg = 110\n"
    "[spline]\n"
    "segments = 38\n"
    "[objective]\n"
    "velocity = 0.4\n"
    "acceleration = 0.4\n"
    "jerk = 0.2\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "base_radius_mm = 16\n"
    "roller_radius_mm = 8\n"
    "offset_mm = 5\n"
    "[limits]\n"
    "pressure_angle_deg = 30\n"
    "cam_radius_min_mm = 4\n";

static void must(camopt_error code) {
    if (code == CAMOPT_OK) return;
    fprintf(stderr, "%s: %s\n", camopt_error_name(code), camopt_error_text());
    exit(1);
}

static void print_limits(const camopt_solution* solution) {
    camopt_constraint limit;
    size_t i, count = 0;
    must(camopt_constraint_count(solution, &count));
    for (i = 0; i < count; ++i) {
        limit.size = sizeof limit;
        must(camopt_constraint_at(solution, i, &limit));
        printf("%s = %g %s: reached %.4f%s\n", limit.key, limit.limit, limit.unit, limit.worst,
               limit.active ? " (active)" : "");
    }
}

static void print_profile(const camopt_solution* solution) {
    camopt_profile_point* points;
    size_t count = 0;
    must(camopt_profile(solution, 360, 0, NULL, 0, &count));
    points = (camopt_profile_point*)malloc(count * sizeof *points);
    if (points == NULL) exit(1);
    must(camopt_profile(solution, 360, 0, points, count, &count));
    printf("%zu points; at %.1f deg the cam is at (%.4f, %.4f) mm\n", count, points[0].theta_deg,
           points[0].cam_mm[0], points[0].cam_mm[1]);
    free(points);
}

int main(int count, char** arguments) {
    camopt_scene* scene = NULL;
    camopt_solution* solution = NULL;
    camopt_summary summary;
    camopt_text drawing = {NULL, 0};

    must(camopt_scene_from_toml(scene_text, "cam", &scene));
    must(camopt_solve(scene, NULL, &solution));
    camopt_scene_free(scene);
    summary.size = sizeof summary;
    must(camopt_solution_summary(solution, &summary));
    printf("%s: objective %.6f\n", camopt_verdict_name(summary.verdict), summary.objective);
    print_limits(solution);
    if (summary.has_cam) {
        print_profile(solution);
        must(camopt_solution_text(solution, CAMOPT_PROFILE_DXF, &drawing));
        printf("drawing: %s\n", strstr(drawing.data, "\nEOF") != NULL ? "complete" : "cut off");
        if (count > 1) {
            FILE* file = fopen(arguments[1], "wb");
            size_t written = file == NULL ? 0 : fwrite(drawing.data, 1, drawing.length, file);
            /* A full disk may be reported only where the file is closed. */
            if (file == NULL || fclose(file) != 0 || written != drawing.length) exit(1);
        }
        camopt_text_free(&drawing);
    }
    camopt_solution_free(solution);
    return 0;
}
