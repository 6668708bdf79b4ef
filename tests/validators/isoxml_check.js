// Reads a TASKDATA folder with the npm package isoxml, a reader that shares nothing with ours, and prints
// what it found as JSON. Exit status: 0 read without a warning, 1 warnings or unreadable, 2 wrong usage.
'use strict';
const fs = require('fs');
const path = require('path');

const modules = process.env.FURROW_NODE_MODULES;
const folder = process.argv[2];
if (!modules || !folder) {
    console.error('usage: FURROW_NODE_MODULES=... node isoxml_check.js FOLDER_WITH_TASKDATA_XML');
    process.exit(2);
}
const fromModules = require('module').createRequire(path.join(modules, 'any.js'));
const { ISOXMLManager } = fromModules('isoxml');
const JSZip = fromModules('jszip');

const listOf = (value) => value || [];
const points = (line) => line.attributes.Point.map((point) => point.attributes)
    .map((point) => ({ type: point.PointType, lon: point.PointEast, lat: point.PointNorth }));

function describeField({ attributes }) {
    return {
        name: attributes.PartfieldDesignator,
        area: attributes.PartfieldArea,
        polygons: listOf(attributes.PolygonnonTreatmentZoneonly).map((polygon) => ({
            type: polygon.attributes.PolygonType,
            name: polygon.attributes.PolygonDesignator,
            rings: polygon.attributes.LineString.map((ring) => (
                { type: ring.attributes.LineStringType, points: points(ring) })),
        })),
        gates: listOf(attributes.Point).map((point) => point.attributes).map((point) => (
            { type: point.PointType, name: point.PointDesignator, lon: point.PointEast, lat: point.PointNorth })),
        lines: listOf(attributes.GuidanceGroup)
            .flatMap((group) => listOf(group.attributes.GuidancePattern))
            .map((pattern) => pattern.attributes)
            .map((pattern) => ({
                name: pattern.GuidancePatternDesignator,
                type: pattern.GuidancePatternType,
                heading: pattern.GuidancePatternHeading,
                width: pattern.LineString[0].attributes.LineStringWidth,
                points: points(pattern.LineString[0]),
            })),
    };
}

async function main() {
    // The reader takes the folder as it would arrive from a stick: zipped, under the name TASKDATA.
    const zip = new JSZip();
    for (const file of fs.readdirSync(folder)) {
        zip.file('TASKDATA/' + file, fs.readFileSync(path.join(folder, file)));
    }
    const manager = new ISOXMLManager();
    await manager.parseISOXMLFile(await zip.generateAsync({ type: 'uint8array' }), 'application/zip');
    const warnings = manager.getWarnings();
    const fields = listOf(manager.rootElement.attributes.Partfield).map(describeField);
    console.log(JSON.stringify({ version: manager.options.version, warnings, fields }));
    process.exitCode = warnings.length > 0 ? 1 : 0;
}

main().catch((error) => {
    console.error(String(error));
    process.exitCode = 1;
});
