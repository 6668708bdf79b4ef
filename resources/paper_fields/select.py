#!/usr/bin/env python3
"""Chooses the fields of the paper's second experiment from a collection of real ones.

    python3 select.py all_fields.geojson > paper_fields.geojson

The shapes that the paper used are not public. The rule here: one part, no holes, a licence that asks for
nothing or for attribution (CC0, DL-DE-ZERO, public domain, CC-BY-4.0), 0.3 to 30 ha, elongation under 10; outline cleaned by
Douglas-Peucker with a hundredth of the square root of the area (1 m on a hectare); strictly convex after
that (every corner turns by more than half a degree); more than 4 corners. The sources take turns, each in
the order of its file, until there are 38.
"""
import json
import math
import sys

LICENCES = ("CC0-1.0", "DL-DE-ZERO-2.0", "public domain", "CC-BY-4.0")
WANTED = 38


def plane(ring):
    lat0 = sum(p[1] for p in ring) / len(ring)
    k = math.pi / 180 * 6371000
    return [((p[0] - ring[0][0]) * k * math.cos(math.radians(lat0)), (p[1] - ring[0][1]) * k) for p in ring]


def area(points):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))


def off(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    return abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / (math.hypot(dx, dy) or 1e-9)


def simplified(points, first, last, tolerance):
    """Indices kept between two, without the last."""
    worst, at = 0.0, None
    for i in range(first + 1, last):
        d = off(points[i], points[first], points[last % len(points)])
        if d > worst:
            worst, at = d, i
    if worst <= tolerance:
        return [first]
    return simplified(points, first, at, tolerance) + simplified(points, at, last, tolerance)


def cleaned(points, tolerance):
    """Split at the corner farthest from the first, which is itself the farthest from the centre."""
    centre = (sum(p[0] for p in points) / len(points), sum(p[1] for p in points) / len(points))
    start = max(range(len(points)), key=lambda i: math.dist(points[i], centre))
    order = list(range(start, len(points))) + list(range(start))
    turned = [points[i] for i in order]
    far = max(range(len(turned)), key=lambda i: math.dist(turned[i], turned[0]))
    kept = simplified(turned, 0, far, tolerance) + simplified(turned, far, len(turned), tolerance)
    return [order[i] for i in kept]


def strictly_convex(points):
    n = len(points)
    for i in range(n):
        a, b, c = points[i - 1], points[i], points[(i + 1) % n]
        first = math.atan2(b[1] - a[1], b[0] - a[0])
        second = math.atan2(c[1] - b[1], c[0] - b[0])
        turn = math.remainder(second - first, 2 * math.pi)
        if turn < math.radians(0.5):
            return False
    return True


def candidate(feature):
    p, g = feature["properties"], feature["geometry"]
    if p["n_parts"] != 1 or p["n_holes"] or not p["valid"] or not p["licence"].startswith(LICENCES):
        return None
    if not 0.3 <= p["area_ha"] <= 30 or p["elongation"] >= 10:
        return None
    rings = g["coordinates"] if g["type"] == "Polygon" else g["coordinates"][0]
    ring = [q[:2] for q in rings[0][:-1]]
    if area(plane(ring)) < 0:
        ring.reverse()
    points = plane(ring)
    kept = cleaned(points, 0.01 * math.sqrt(abs(area(points))))
    if len(kept) < 5 or not strictly_convex([points[i] for i in kept]):
        return None
    outline = [[round(v, 7) for v in ring[i]] for i in kept]
    return {"type": "Feature", "id": p["id"],
            "properties": {"name": p["id"], "source": p["source"], "licence": p["licence"],
                           "country": p["country"], "area_ha": p["area_ha"]},
            "geometry": {"type": "Polygon", "coordinates": [outline + outline[:1]]}}


def main():
    sources = {}
    with open(sys.argv[1]) as file:
        for feature in json.load(file)["features"]:
            found = candidate(feature)
            if found:
                sources.setdefault(found["properties"]["source"], []).append(found)
    chosen = []
    while len(chosen) < WANTED and any(sources.values()):
        for fields in sources.values():
            if fields and len(chosen) < WANTED:
                chosen.append(fields.pop(0))
    chosen.sort(key=lambda f: f["id"])
    print('{"type":"FeatureCollection","features":[')
    print(",\n".join(json.dumps(f, separators=(",", ":")) for f in chosen))
    print("]}")


main()
