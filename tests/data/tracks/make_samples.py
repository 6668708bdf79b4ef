#!/usr/bin/env python3
"""Makes the recordings in this folder: the same four corners in every format, invented for the tests.

    python3 make_samples.py

Longitude 5.66 and 5.6601, latitude 52.09 and 52.0901, two seconds apart from 2026-05-04 10:00:00 UTC
(1777888800); in local metres (0,0) (6,0) (6,8) (0,8). The implement is down from the second to the third.
"""
import os
import sqlite3
import struct
import zipfile
import zlib

START = 1777888800
CORNERS = [(5.66, 52.09), (5.6601, 52.09), (5.6601, 52.0901), (5.66, 52.0901)]
LOCAL = [(0, 0), (6, 0), (6, 8), (0, 8)]
DOWN = [0, 1, 1, 0]
BEARING = [90, 90, 0, 270]  # course over ground
SPEED = [3.0, 3.0, 4.0, 3.0]


def write(name, content):
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    with open(name, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def clock(i, form):
    second = 2 * i
    return form.format(second=f"{second:02}")


def gpx():
    points = "".join(
        f'   <trkpt lat="{lat}" lon="{lon}"><time>{clock(i, "2026-05-04T12:00:{second}+02:00")}</time>'
        f"<extensions><speed>{SPEED[i]}</speed><course>{BEARING[i]}</course></extensions></trkpt>\n"
        for i, (lon, lat) in enumerate(CORNERS))
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<gpx version="1.1" creator="by hand" xmlns="http://www.topografix.com/GPX/1/1">\n'
            f" <trk><name>Corners</name>\n  <trkseg>\n{points}  </trkseg>\n  <trkseg/>\n </trk>\n</gpx>\n")


def table():
    rows = "".join(
        f'{clock(i, "2026-05-04 10:00:{second}")};{str(lat).replace(".", ",")};{str(lon).replace(".", ",")};'
        f'{str(SPEED[i] * 3.6).replace(".", ",")[:5]};{BEARING[i]};{DOWN[i]}\n'
        for i, (lon, lat) in enumerate(CORNERS))
    return ("Maschine;Beispiel 1\nFahrer;niemand\n\n"
            f"Time;Latitude;Longitude;Speed (km/h);Course;Work state\n{rows};;;;;\n")


def yield_monitor():
    return "".join(
        f'{lon:.6f},{lat:.6f},{10 + i}.00,{START + 2 * i},2,{round(SPEED[i] * 2 / 0.0254)},360,15.0,33,1,7,'
        f'"F0:CORNERS","L0:26/05/04","CORN",7,0,100.0\n'
        for i, (lon, lat) in enumerate(CORNERS))


def gpsd():
    lines = ['{"class":"VERSION","release":"3.17"}', '{"class":"TPV","mode":1}']
    for i, (lon, lat) in enumerate(CORNERS):
        lines.append(f'{{"class":"TPV","mode":3,"time":"{clock(i, "2026-05-04T10:00:{second}.000Z")}",'
                     f'"lat":{lat},"lon":{lon},"track":{BEARING[i]},"speed":{SPEED[i]}}}')
    return "\n".join(lines) + "\n"


def nmea():
    def sentence(body):
        total = 0
        for letter in body:
            total ^= ord(letter)
        return f"${body}*{total:02X}\r\n"

    def minutes(value, width):
        return f"{int(value):0{width}}{(value - int(value)) * 60:09.6f}"

    text = "# by hand\r\n"
    for i, (lon, lat) in enumerate(CORNERS):
        place = f"{minutes(lat, 2)},N,{minutes(lon, 3)},E"
        text += sentence(f"GNGGA,{clock(i, '1000{second}')}.00,{place},4,12,0.7,10.0,M,45.0,M,1.0,0001")
        text += sentence(
            f"GNRMC,{clock(i, '1000{second}')}.00,A,{place},{SPEED[i] * 3600 / 1852:.6f},{BEARING[i]},040526,,,R")
    return text + "$GNRMC,100008.00,A,5205.4,N,00539.6,E,0,0,040526,,,R*00\r\n"


def isoxml(folder):
    write(f"{folder}/TASKDATA.XML",
          '<?xml version="1.0" encoding="UTF-8"?>\n<ISO11783_TaskData VersionMajor="4" VersionMinor="3" '
          'ManagementSoftwareManufacturer="by hand" ManagementSoftwareVersion="1" DataTransferOrigin="2">\n'
          ' <TSK A="TSK1" B="Corners" G="4"><TLG A="TLG00001" C="1"/></TSK>\n</ISO11783_TaskData>\n')
    # Height is not in the records (it is missing), the status is 4 in all of them (it has a value).
    write(f"{folder}/TLG00001.XML",
          '<?xml version="1.0" encoding="UTF-8"?>\n<TIM A="" D="4">\n <PTN A="" B="" D="4" H="" I=""/>\n'
          ' <DLV A="0043" B="" C="DET-1"/>\n <DLV A="008D" B="" C="DET-1"/>\n <DLV A="018D" B="" C="DET-1"/>\n'
          "</TIM>\n")
    days = START // 86400 - 3652  # since 1980-01-01
    records = b""
    for i, (lon, lat) in enumerate(CORNERS):
        # The terminal's clock is two hours ahead of UTC.
        records += struct.pack("<IH", (12 * 3600 + 2 * i) * 1000, days)
        records += struct.pack("<iiIH", round(lat * 1e7), round(lon * 1e7), (10 * 3600 + 2 * i) * 1000, days)
        values = [(2, round(SPEED[i] * 1000))]
        if i == 0 or DOWN[i] != DOWN[i - 1]:
            values.append((1, DOWN[i]))
        records += struct.pack("<B", len(values)) + b"".join(struct.pack("<Bi", *value) for value in values)
    # A record without a position.
    records += struct.pack("<IHiiIHB", 0, days, 0x7FFFFFFF, 0x7FFFFFFF, 0, days, 0)
    write(f"{folder}/TLG00001.BIN", records)


class Cdr:
    def __init__(self):
        self.body = b""

    def put(self, form, *values):
        for value in values:
            size = struct.calcsize(form)
            self.body += b"\0" * (-len(self.body) % size) + struct.pack("<" + form, value)
        return self

    def text(self, value):
        raw = value.encode() + b"\0"
        self.put("I", len(raw))
        self.body += raw
        return self

    def header(self, i, frame):
        return self.put("i", START + 2 * i).put("I", 0).text(frame)

    def pose(self, i):
        x, y = LOCAL[i]
        # Yaw 0, 0, 90 and 180 degrees.
        z, w = [(0, 1), (0, 1), (0.5 ** 0.5, 0.5 ** 0.5), (1, 0)][i]
        return self.put("d", x, y, 0, 0, 0, z, w)

    def done(self):
        return b"\0\1\0\0" + self.body


def fix(i):
    lon, lat = CORNERS[i]
    cdr = Cdr().header(i, "gps").put("b", 2).put("H", 1).put("d", lat, lon, 10.0, *([0.0] * 9))
    return cdr.put("B", 0).done()


def odometry(i):
    return (Cdr().header(i, "map").text("base_link").pose(i).put("d", *([0.0] * 36)).put("d", SPEED[i], 0, 0, 0, 0, 0)
            .put("d", *([0.0] * 36)).done())


def path():
    cdr = Cdr().header(0, "map").put("I", 4)
    for i in range(4):
        cdr.header(0, "map").pose(i)
    return cdr.done()


def bag_sqlite(folder):
    os.makedirs(folder, exist_ok=True)
    name = f"{folder}/drive_0.db3"
    if os.path.exists(name):
        os.remove(name)
    with sqlite3.connect(name) as base:
        base.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,"
                     "serialization_format TEXT NOT NULL,offered_qos_profiles TEXT NOT NULL)")
        base.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL, "
                     "timestamp INTEGER NOT NULL, data BLOB NOT NULL)")
        base.execute("INSERT INTO topics VALUES(1,'/fix','sensor_msgs/msg/NavSatFix','cdr','')")
        base.execute("INSERT INTO topics VALUES(2,'/odom','nav_msgs/msg/Odometry','cdr','')")
        for i in range(4):
            base.execute("INSERT INTO messages(topic_id,timestamp,data) VALUES(1,?,?)",
                         ((START + 2 * i) * 10 ** 9, fix(i)))
            base.execute("INSERT INTO messages(topic_id,timestamp,data) VALUES(2,?,?)",
                         ((START + 2 * i) * 10 ** 9, odometry(i)))


def mcap(messages, topic, kind):
    def text(value):
        return struct.pack("<I", len(value)) + value.encode()

    def record(opcode, body):
        return struct.pack("<BQ", opcode, len(body)) + body

    inner = record(3, struct.pack("<H", 1) + text(kind) + text("ros2msg") + text(""))
    inner += record(4, struct.pack("<HH", 1, 1) + text(topic) + text("cdr") + struct.pack("<I", 0))
    for i, message in enumerate(messages):
        stamp = (START + 2 * i) * 10 ** 9
        inner += record(5, struct.pack("<HIQQ", 1, i, stamp, stamp) + message)
    chunk = struct.pack("<QQQI", 0, 0, len(inner), zlib.crc32(inner)) + text("") + struct.pack("<Q", len(inner))
    magic = b"\x89MCAP0\r\n"
    return (magic + record(1, text("ros2") + text("by hand")) + record(6, chunk + inner) +
            record(15, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0)) + magic)


if __name__ == "__main__":
    os.chdir(os.path.dirname(os.path.abspath(__file__)))
    write("corners.gpx", gpx())
    write("corners_semicolon.csv", table())
    write("corners_yield_monitor.txt", yield_monitor())
    write("corners_gpsd.log", gpsd())
    write("corners_nmea.log", nmea())
    isoxml("isoxml/TASKDATA")
    with zipfile.ZipFile("corners_isoxml.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("TASKDATA.XML", "TLG00001.XML", "TLG00001.BIN"):

            archive.write(f"isoxml/TASKDATA/{name}", f"job/TASKDATA/{name}")
        archive.writestr("../../escaped.txt", "nothing may be written outside")
    bag_sqlite("rosbag_sqlite3")
    write("odometry.mcap", mcap([odometry(i) for i in range(4)], "/odom", "nav_msgs/msg/Odometry"))
    write("path.mcap", mcap([path()], "/plan", "nav_msgs/msg/Path"))
