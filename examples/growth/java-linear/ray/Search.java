package ray;

import java.util.List;

/** Asks every surface. */
class Search {

    private final List<Surface> surfaces;

    Search(List<Surface> surfaces) {
        this.surfaces = surfaces;
    }

    void closest(Ray ray, Hit hit) {
        for (Surface surface : surfaces) {
            surface.intersect(ray, hit);
        }
    }
}
