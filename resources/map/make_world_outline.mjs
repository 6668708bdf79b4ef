// Makes world_outline.bin from countries-50m.json of the world-atlas package (Natural Earth, public domain).
// Usage: node make_world_outline.mjs countries-50m.json world_outline.bin
//
// The file: "FWO1", then two lists (land rings, border lines). A list is the number of lines, then for each
// line the number of points and the points as differences; all numbers are zigzag varints. A point is
// longitude and latitude in steps of 0.005 degrees; longitudes may go beyond 180.
import { readFileSync, writeFileSync } from "node:fs";

const [input, output] = process.argv.slice(2);
const atlas = JSON.parse(readFileSync(input, "utf8"));
const stepsPerDegree = 200;
const { scale, translate } = atlas.transform;

const arcs = atlas.arcs.map(arc => {
    let x = 0, y = 0;
    return arc.map(([dx, dy]) => {
        x += dx;
        y += dy;
        return [Math.round((x * scale[0] + translate[0]) * stepsPerDegree),
                Math.round((y * scale[1] + translate[1]) * stepsPerDegree)];
    });
});
const arcPoints = index => index < 0 ? [...arcs[~index]].reverse() : arcs[index];

const withoutRepeats = line => line.filter((p, i) => i === 0 || p[0] !== line[i - 1][0] || p[1] !== line[i - 1][1]);

const world = 360 * stepsPerDegree;

// Rings that cross the antimeridian go on beyond 180 degrees instead of jumping back; one that runs around
// the pole is closed along it.
const unwrapped = ring => {
    let turns = 0;
    const points = ring.map(([x, y], i) => {
        if (i > 0) turns -= Math.round((x - ring[i - 1][0]) / world);
        return [x + turns * world, y];
    });
    const [first, last] = [points[0], points.at(-1)];
    if (Math.abs(last[0] - first[0]) < world / 2) return points;
    const pole = (last[1] < 0 ? -90 : 90) * stepsPerDegree;
    return [...points, [first[0] + Math.round((last[0] - first[0]) / world) * world, first[1]],
            [first[0] + Math.round((last[0] - first[0]) / world) * world, pole], [first[0], pole]];
};

const polygonsOf = geometry => geometry.type === "GeometryCollection" ? geometry.geometries.flatMap(polygonsOf)
    : geometry.type === "MultiPolygon" ? geometry.arcs
    : geometry.type === "Polygon" ? [geometry.arcs] : [];

const rings = polygonsOf(atlas.objects.land)
    .flatMap(polygon => polygon.map(ring => unwrapped(withoutRepeats(ring.flatMap(arcPoints)).slice(0, -1))))
    .filter(ring => ring.length >= 3);

const users = new Map();
for (const country of atlas.objects.countries.geometries) {
    for (const index of new Set(polygonsOf(country).flat(2).map(i => i < 0 ? ~i : i))) {
        users.set(index, (users.get(index) ?? 0) + 1);
    }
}
const borders = [...users].filter(([, count]) => count > 1).map(([index]) => withoutRepeats(arcs[index]))
    .filter(line => line.length >= 2);

const bytes = [...Buffer.from("FWO1")];
const put = value => {
    let rest = value >= 0 ? value * 2 : -value * 2 - 1;
    while (rest >= 128) {
        bytes.push(rest % 128 + 128);
        rest = Math.floor(rest / 128);
    }
    bytes.push(rest);
};
for (const lines of [rings, borders]) {
    put(lines.length);
    for (const line of lines) {
        put(line.length);
        let [x, y] = [0, 0];
        for (const point of line) {
            put(point[0] - x);
            put(point[1] - y);
            [x, y] = point;
        }
    }
}
writeFileSync(output, Buffer.from(bytes));
console.log(`${rings.length} rings, ${borders.length} borders, ${bytes.length} bytes`);
