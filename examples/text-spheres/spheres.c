/* A ray tracer for matte spheres.
 *
 *   gcc -O2 -std=c99 -o spheres spheres.c -lm
 *   ./spheres scene.txt picture.ppm
 *
 * A scene is a text of one item a line; the rest of a line after # is ignored:
 *
 *   size WIDTH HEIGHT               the picture, in pixels (needed)
 *   camera X Y Z                    the eye, which looks along -z with y up; default 0 0 0
 *   window DISTANCE WIDTH HEIGHT    the window that it looks through; default 1 1 1
 *   light X Y Z  R G B              a point light
 *   sphere X Y Z RADIUS  R G B      a sphere and its diffuse colour
 *
 * The picture is a binary PPM. A wrong scene gives a message, no picture, and exit status 1.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_ITEMS 1000
#define EPSILON 1e-6 /* a shadow ray starts this far along, so that it leaves its own sphere */

typedef struct {
  double x, y, z;
} Vec;

typedef struct {
  Vec center;
  double radius;
  Vec color;
} Sphere;

typedef struct {
  Vec position, color;
} Light;

typedef struct {
  int width, height;
  Vec eye;
  double distance, window_width, window_height;
  int spheres, lights;
  Sphere sphere[MAX_ITEMS];
  Light light[MAX_ITEMS];
} Scene;

static Vec sub(Vec a, Vec b) {
  Vec r = {a.x - b.x, a.y - b.y, a.z - b.z};
  return r;
}

/* a + s b */
static Vec along(Vec a, double s, Vec b) {
  Vec r = {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
  return r;
}

static double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static Vec unit(Vec a) {
  double length = sqrt(dot(a, a));
  Vec r = {a.x / length, a.y / length, a.z / length};
  return r;
}

/* Reads a scene. Returns 0 after a message if there is something wrong with it. */
static int read_scene(const char *path, Scene *s) {
  FILE *file = fopen(path, "r");
  char line[512], word[16];
  int number = 0;
  if (!file) {
    fprintf(stderr, "%s: cannot open it\n", path);
    return 0;
  }
  while (fgets(line, sizeof line, file)) {
    double v[7];
    char rest[2];
    int n;
    ++number;
    line[strcspn(line, "#")] = '\0';
    n = sscanf(line, "%15s %lf %lf %lf %lf %lf %lf %lf %1s", word, &v[0], &v[1], &v[2], &v[3], &v[4],
               &v[5], &v[6], rest) - 1;
    if (n < 0) continue; /* an empty line */
    if (strcmp(word, "size") == 0 && n == 2 && v[0] >= 1 && v[1] >= 1 && v[0] < 1e5 && v[1] < 1e5) {
      s->width = (int)v[0];
      s->height = (int)v[1];
    } else if (strcmp(word, "camera") == 0 && n == 3) {
      Vec eye = {v[0], v[1], v[2]};
      s->eye = eye;
    } else if (strcmp(word, "window") == 0 && n == 3) {
      s->distance = v[0];
      s->window_width = v[1];
      s->window_height = v[2];
    } else if (strcmp(word, "light") == 0 && n == 6 && s->lights < MAX_ITEMS) {
      Light light = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
      s->light[s->lights++] = light;
    } else if (strcmp(word, "sphere") == 0 && n == 7 && v[3] >= 0 && s->spheres < MAX_ITEMS) {
      Sphere sphere = {{v[0], v[1], v[2]}, v[3], {v[4], v[5], v[6]}};
      s->sphere[s->spheres++] = sphere;
    } else {
      fprintf(stderr, "%s:%d: cannot read this line\n", path, number);
      fclose(file);
      return 0;
    }
  }
  fclose(file);
  if (s->width == 0) fprintf(stderr, "%s: the size of the picture is missing\n", path);
  return s->width > 0;
}

/* The first sphere that the ray hits with EPSILON <= t <= *t, or NULL; sets *t. */
static const Sphere *intersect(const Scene *s, Vec origin, Vec direction, double *t) {
  const Sphere *found = NULL;
  int i, k;
  for (i = 0; i < s->spheres; ++i) {
    const Sphere *sphere = &s->sphere[i];
    Vec o = sub(origin, sphere->center);
    double a = dot(direction, direction), b = dot(o, direction);
    double c = dot(o, o) - sphere->radius * sphere->radius;
    double discriminant = b * b - a * c;
    if (discriminant < 0) continue;
    for (k = -1; k <= 1; k += 2) {
      double root = (-b + k * sqrt(discriminant)) / a;
      if (root < EPSILON || root > *t || (found && root == *t)) continue;
      *t = root;
      found = sphere;
    }
  }
  return found;
}

static Vec trace(const Scene *s, Vec origin, Vec direction) {
  Vec color = {0, 0, 0}, point, normal;
  double t = HUGE_VAL;
  const Sphere *sphere = intersect(s, origin, direction, &t);
  int i;
  if (!sphere) return color;
  point = along(origin, t, direction);
  normal = unit(sub(point, sphere->center));
  for (i = 0; i < s->lights; ++i) {
    Vec to_light = sub(s->light[i].position, point), c = s->light[i].color;
    double cosine = dot(normal, unit(to_light)), reach = 1;
    if (cosine <= 0 || intersect(s, point, to_light, &reach)) continue;
    color.x += sphere->color.x * c.x * cosine;
    color.y += sphere->color.y * c.y * cosine;
    color.z += sphere->color.z * c.z * cosine;
  }
  return color;
}

/* Linear light to a byte, with gamma 2.2. */
static int encode(double linear) {
  float c = (float)pow(linear, 1 / 2.2);
  if (c > 1) c = 1;
  return (int)floor(255.0 * c + 0.5);
}

int main(int argc, char **argv) {
  static Scene scene;
  FILE *out;
  int x, y;
  scene.distance = scene.window_width = scene.window_height = 1;
  if (argc != 3) {
    fprintf(stderr, "usage: spheres scene.txt picture.ppm\n");
    return 1;
  }
  if (!read_scene(argv[1], &scene)) return 1;
  out = fopen(argv[2], "wb");
  if (!out) {
    fprintf(stderr, "%s: cannot write it\n", argv[2]);
    return 1;
  }
  fprintf(out, "P6\n%d %d\n255\n", scene.width, scene.height);
  for (y = scene.height - 1; y >= 0; --y) /* row 0 is the bottom one, a PPM starts at the top */
    for (x = 0; x < scene.width; ++x) {
      Vec direction, color;
      direction.x = ((x + 0.5) / scene.width - 0.5) * scene.window_width;
      direction.y = ((y + 0.5) / scene.height - 0.5) * scene.window_height;
      direction.z = -scene.distance;
      color = trace(&scene, scene.eye, unit(direction));
      fputc(encode(color.x), out);
      fputc(encode(color.y), out);
      fputc(encode(color.z), out);
    }
  if (fclose(out) != 0) {
    fprintf(stderr, "%s: cannot write it\n", argv[2]);
    return 1;
  }
  return 0;
}
