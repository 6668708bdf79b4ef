#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <format>
#include <fstream>
#include <set>

using namespace furrow;

class TestMachineFile : public QObject {
    Q_OBJECT

private slots:
    void readsEveryKey();
    void keepsDefaults();
    void trailedImplementReversesOnlyWhereSaid();
    void writesWhatItReads_data();
    void writesWhatItReads();
    void anglesStayReadable();
    void refuses_data();
    void refuses();
    void readsFiles();
    void keysGetAndSet();
    void paperRobotComesFirst();
    void findsMachines_data();
    void findsMachines();
    void unknownMachineListsTheKnown();
    void transportWidth();
    void timeToFold();
    void libraryFolds();
};

void TestMachineFile::readsEveryKey() {
    const auto machine = parseMachine(R"({
        "id": "t", "name": "Test", "vehicle_width_m": 2.4, "vehicle_length_m": 4.8, "rear_overhang_m": 1.1,
        "wheelbase_m": 2.7, "min_turning_radius_m": 5.5, "max_steering_angle_deg": 40,
        "max_curvature_rate_1pm2": 0.2, "steering_rate_degps": 18, "can_reverse": false, "can_turn_in_place": true,
        "working_speed_mps": 2.1, "turning_speed_mps": 1.2, "transfer_speed_mps": 3.3, "reverse_speed_mps": 0.9,
        "max_acceleration_mps2": 0.4, "max_lateral_acceleration_mps2": 1.3, "operating_width_m": 6,
        "raised_width_m": 3, "implement_mounting": "trailed", "implement_hitch_offset_m": -1.2,
        "implement_offset_m": -4.5, "implement_lateral_offset_m": 0.3, "implement_length_m": 2.2,
        "max_hitch_angle_deg": 60, "lift_time_s": 3, "lower_time_s": 4, "run_in_m": 1.5,
        "implement_can_reverse": true, "tank_capacity": 900, "tank_rate_per_m2": 0.02,
        "fuel_working_lph": 21, "fuel_turning_lph": 9})",
                                      "test.json");
    QVERIFY2(machine, machine ? "" : machine.error().line().c_str());
    const MachineSpec& spec = machine->spec();
    QCOMPARE(spec.id, std::string{"t"});
    QCOMPARE(spec.name, std::string{"Test"});
    QCOMPARE(spec.tractor.width.si(), 2.4);
    QCOMPARE(spec.tractor.length.si(), 4.8);
    QCOMPARE(spec.tractor.rearOverhang.si(), 1.1);
    QCOMPARE(spec.tractor.wheelbase.si(), 2.7);
    QCOMPARE(spec.tractor.minTurningRadius->si(), 5.5);
    QCOMPARE(spec.tractor.maxSteeringAngle->si(), 0.698131700797732);  // 40 pi / 180
    QCOMPARE(spec.tractor.maxCurvatureRate->si(), 0.2);
    QCOMPARE(*spec.tractor.steeringRateRadps, 0.314159265358979);  // 18 pi / 180
    QVERIFY(!spec.tractor.canReverse);
    QVERIFY(spec.tractor.canTurnInPlace);
    QCOMPARE(spec.tractor.workingSpeed.si(), 2.1);
    QCOMPARE(spec.tractor.turningSpeed.si(), 1.2);
    QCOMPARE(spec.tractor.transferSpeed.si(), 3.3);
    QCOMPARE(spec.tractor.reverseSpeed.si(), 0.9);
    QCOMPARE(spec.tractor.maxAcceleration.si(), 0.4);
    QCOMPARE(spec.tractor.maxLateralAcceleration.si(), 1.3);
    QCOMPARE(spec.implement.operatingWidth.si(), 6.0);
    QCOMPARE(spec.implement.raisedWidth->si(), 3.0);
    QVERIFY(spec.implement.mounting == Mounting::Trailed);
    QCOMPARE(spec.implement.hitchOffset.si(), -1.2);
    QCOMPARE(spec.implement.offset.si(), -4.5);
    QCOMPARE(spec.implement.lateralOffset.si(), 0.3);
    QCOMPARE(spec.implement.length.si(), 2.2);
    QCOMPARE(spec.implement.maxHitchAngle->si(), 1.0471975511966);  // pi / 3
    QCOMPARE(spec.implement.liftTime.si(), 3.0);
    QCOMPARE(spec.implement.lowerTime.si(), 4.0);
    QCOMPARE(spec.implement.runIn.si(), 1.5);
    QVERIFY(spec.implement.canReverse);
    QCOMPARE(spec.tank->capacity, 900.0);
    QCOMPARE(spec.tank->ratePerM2, 0.02);
    QCOMPARE(spec.fuel->workingLph, 21.0);
    QCOMPARE(spec.fuel->turningLph, 9.0);
}

void TestMachineFile::keepsDefaults() {
    const auto machine =
        parseMachine(R"({"operating_width_m": 3, "min_turning_radius_m": 5})", "my drill.json");
    QVERIFY(machine);
    MachineSpec expected;
    expected.id = expected.name = "my drill";
    expected.implement.operatingWidth = metres(3.0);
    expected.tractor.minTurningRadius = metres(5.0);
    QVERIFY(machine->spec() == expected);
}

void TestMachineFile::trailedImplementReversesOnlyWhereSaid() {
    const auto silent = parseMachine(
        R"({"operating_width_m": 3, "min_turning_radius_m": 5, "implement_mounting": "trailed"})", "m");
    QVERIFY(silent && !silent->spec().implement.canReverse);
    const auto said = parseMachine(R"({"implement_can_reverse": true, "operating_width_m": 3,
        "min_turning_radius_m": 5, "implement_mounting": "trailed"})",
                                   "m");
    QVERIFY(said && said->spec().implement.canReverse);
}

void TestMachineFile::writesWhatItReads_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < machineLibrary().size(); ++i) {
        QTest::newRow(machineLibrary()[i].id().c_str()) << static_cast<int>(i);
    }
}

void TestMachineFile::writesWhatItReads() {
    QFETCH(int, index);
    const Machine& machine = machineLibrary()[static_cast<std::size_t>(index)];
    const std::string written = machineJson(machine.spec());
    const auto read = parseMachine(written, "written");
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QVERIFY(*read == machine);
    QCOMPARE(machineJson(read->spec()), written);
}

void TestMachineFile::anglesStayReadable() {
    for (const double given : {1.0, 30.0, 33.3, 41.25, 89.999}) {
        MachineSpec spec;
        spec.tractor.maxSteeringAngle = degrees(given);
        const std::string json = machineJson(spec);
        QVERIFY2(json.contains(std::format("\"max_steering_angle_deg\": {}", given)), json.c_str());
    }
    // One that has no short number of degrees still comes back to the last bit.
    MachineSpec odd;
    odd.tractor.maxSteeringAngle = radians(0.7);
    const auto read = parseMachine(machineJson(odd), "odd");
    QVERIFY(read && read->spec().tractor.maxSteeringAngle == radians(0.7));
}

void TestMachineFile::refuses_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("text");
    QTest::newRow("key with a typing error") << R"({"operating_widht_m": 3})" << "m.json, operating_widht_m"
                                             << "did you mean 'operating_width_m'?";
    QTest::newRow("key nobody knows")
        << R"({"colour_of_the_cab": "red"})" << "m.json, colour_of_the_cab" << "keys look like";
    QTest::newRow("number in quotes") << R"({"operating_width_m": "3"})" << "m.json, operating_width_m"
                                      << "give a number in m";
    QTest::newRow("number for a flag") << R"({"can_reverse": 1})" << "m.json, can_reverse" << "true or false";
    QTest::newRow("number for a name") << R"({"name": 7})" << "m.json, name" << "text in quotes";
    QTest::newRow("null where a value is needed")
        << R"({"operating_width_m": null})" << "m.json, operating_width_m" << "null";
    QTest::newRow("mounting of no kind")
        << R"({"implement_mounting": "towed"})" << "m.json, implement_mounting"
        << "\"mounted\" or \"trailed\"";
    QTest::newRow("the same key twice")
        << R"({"operating_width_m": 3, "operating_width_m": 4})" << "m.json, operating_width_m" << "twice";
    QTest::newRow("comma too many") << "{\n  \"operating_width_m\": 3,\n}" << "m.json, line 3, column 1"
                                    << "not JSON from here";
    QTest::newRow("cut off") << "{\"operating_width_m\": 3" << "m.json, line 1" << "not JSON from here";
    QTest::newRow("empty") << "" << "m.json, line 1, column 1" << "not JSON";
    QTest::newRow("NaN") << R"({"operating_width_m": NaN})" << "m.json, line 1" << "not JSON";
    QTest::newRow("number beyond double") << R"({"operating_width_m": 1e999})" << "m.json" << "too large";
    QTest::newRow("list") << "[1, 2]" << "m.json" << "one JSON object";
    QTest::newRow("no operating width") << R"({"min_turning_radius_m": 5})" << "m.json, operating_width_m"
                                        << "missing";
    QTest::newRow("width below zero") << R"({"operating_width_m": -3, "min_turning_radius_m": 5})"
                                      << "operating_width_m" << "-3";
    const auto with = [](const char* member) {
        return QString{R"({"operating_width_m": 3, "min_turning_radius_m": 5, %1})"}.arg(
            QString::fromUtf8(member));
    };
    QTest::newRow("raised width of kilometres")
        << with(R"("raised_width_m": 1e4)") << "raised_width_m" << "did you mean 10 m?";
    QTest::newRow("far to the side") << with(R"("implement_lateral_offset_m": -1e5)")
                                     << "implement_lateral_offset_m" << "give a number from -50 to 50 m";
    QTest::newRow("run-in of kilometres") << with(R"("run_in_m": 1e5)") << "run_in_m" << "100000 m";
    QTest::newRow("radius of kilometres")
        << R"({"operating_width_m": 3, "min_turning_radius_m": 1e6})" << "min_turning_radius_m"
        << "give a number from 0.05 to 200 m";
    QTest::newRow("width of micrometres") << R"({"operating_width_m": 1e-6, "min_turning_radius_m": 5})"
                                          << "operating_width_m" << "give a number from 0.05 to 100 m";
    QTest::newRow("width in millimetres") << R"({"operating_width_m": 7500, "min_turning_radius_m": 5})"
                                          << "operating_width_m" << "did you mean 7.5 m?";
    QTest::newRow("width in centimetres") << R"({"operating_width_m": 750, "min_turning_radius_m": 5})"
                                          << "operating_width_m" << "did you mean 7.5 m?";
    QTest::newRow("wheelbase in millimetres") << with(R"("wheelbase_m": 2700)") << "wheelbase_m"
                                              << "did you mean 2.7 m?";
    QTest::newRow("offset in centimetres") << with(R"("implement_offset_m": -360)") << "implement_offset_m"
                                           << "did you mean -3.6 m?";
    QTest::newRow("speed in km/h") << with(R"("transfer_speed_mps": 40)") << "transfer_speed_mps"
                                   << "did you mean 11.1111 m/s?";
    QTest::newRow("no speed") << with(R"("working_speed_mps": 1e-308)") << "working_speed_mps"
                              << "1e-308 m/s";
    QTest::newRow("less than an empty tank") << with(R"("tank_capacity": -5)") << "tank_capacity" << "-5";
    QTest::newRow("fuel that is made") << with(R"("fuel_working_lph": -5)") << "fuel_working_lph" << "-5 l/h";
    QTest::newRow("hitch angle below zero") << with(R"("max_hitch_angle_deg": -5)") << "max_hitch_angle_deg"
                                            << "-5°";
    QTest::newRow("steering angle that hardly steers")
        << R"({"operating_width_m": 3, "max_steering_angle_deg": 0.5, "wheelbase_m": 3})"
        << "max_steering_angle_deg" << "a turning radius of 343.77 m";
    QTest::newRow("200,000 brackets for a value")
        << with((R"("tank_capacity": )" + std::string(100000, '[') + std::string(100000, ']')).c_str())
        << "m.json, line 1" << "too deep";
    QTest::newRow("an object behind 100 brackets")
        << with((R"("tank_capacity": )" + std::string(100, '[') + "{\"a\": 1}" + std::string(100, ']'))
                    .c_str())
        << "m.json, line 1" << "too deep";
    QTest::newRow("neither radius nor steering angle")
        << R"({"operating_width_m": 3})" << "min_turning_radius_m" << "max_steering_angle_deg";
}

void TestMachineFile::refuses() {
    QFETCH(QString, json);
    QFETCH(QString, where);
    QFETCH(QString, text);
    const auto machine = parseMachine(json.toStdString(), "m.json");
    QVERIFY(!machine);
    QVERIFY(machine.error().code == ErrorCode::InputRefused);
    QVERIFY2(machine.error().where.contains(where.toStdString()), machine.error().line().c_str());
    QVERIFY2(machine.error().line().contains(text.toStdString()), machine.error().line().c_str());
}

void TestMachineFile::readsFiles() {
    const QTemporaryDir folder;
    const std::filesystem::path path = std::filesystem::path{folder.path().toStdString()} / "drill.json";
    const auto missing = readMachineFile(path);
    QVERIFY(!missing && missing.error().code == ErrorCode::ReadFailed);
    const auto isFolder = readMachineFile(path.parent_path());
    QVERIFY(!isFolder && isFolder.error().code == ErrorCode::ReadFailed);
    std::ofstream{path} << "\xEF\xBB\xBF" << R"({"operating_width_m": 3, "min_turning_radius_m": 5})";
    const auto read = readMachineFile(path);
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(read->name(), std::string{"drill"});
}

void TestMachineFile::keysGetAndSet() {
    std::set<std::string_view> seen;
    for (const MachineKey& key : machineKeys()) {
        const std::string name{key.key};
        QVERIFY2(seen.insert(key.key).second, name.c_str());
        QVERIFY2(!key.name.empty() && !key.description.empty(), name.c_str());
        MachineSpec spec;
        MachineValue value;
        switch (key.kind) {
            case MachineKeyKind::Number:
                QVERIFY2(key.min < key.max, name.c_str());
                value = 0.5 * (key.min + key.max);
                break;
            case MachineKeyKind::Flag: value = !std::get<bool>(key.get(spec)); break;
            case MachineKeyKind::Text:
                value = key.choices.empty() ? "x" : std::string{key.choices.back()};
                break;
        }
        key.set(spec, value);
        QVERIFY2(key.get(spec) == value, name.c_str());
        if (key.mayBeMissing) {
            key.set(spec, {});
            QVERIFY2(std::holds_alternative<std::monostate>(key.get(spec)), name.c_str());
        }
    }
    QCOMPARE(seen.size(), 37U);
}

void TestMachineFile::paperRobotComesFirst() {
    // Mier, Valente, de Bruin 2023, section IV: 2.5 m wide, radius 2.1 m, at most 13.5 km/h.
    QVERIFY(machineLibrary().size() >= 12);
    const Machine& robot = machineLibrary().front();
    QCOMPARE(robot.name(), std::string{"AgBot"});
    QCOMPARE(robot.operatingWidth().si(), 2.5);
    QCOMPARE(robot.spec().tractor.width.si(), 2.5);
    QCOMPARE(robot.minTurningRadius().si(), 2.1);
    QCOMPARE(robot.spec().tractor.transferSpeed.si(), 3.75);
}

void TestMachineFile::findsMachines_data() {
    QTest::addColumn<QString>("wanted");
    QTest::newRow("name as written") << "AgBot";
    QTest::newRow("small letters") << "agbot";
    QTest::newRow("capitals") << "AGBOT";
}

void TestMachineFile::findsMachines() {
    QFETCH(QString, wanted);
    const auto machine = findMachine(wanted.toStdString());
    QVERIFY(machine);
    QCOMPARE(machine->id(), std::string{"agbot"});
    for (const Machine& each : machineLibrary()) {
        QVERIFY(findMachine(each.name()) == each);
        QVERIFY(findMachine(each.id()) == each);
    }
}

void TestMachineFile::unknownMachineListsTheKnown() {
    const auto machine = findMachine("agbott");
    QVERIFY(!machine && machine.error().code == ErrorCode::Usage);
    QVERIFY(machine.error().remedy.contains("did you mean 'agbot'?"));
    QVERIFY(machine.error().remedy.contains("trailed-sprayer"));
}

// Folded for transport: as given; as wide as raised where it is not; never narrower than the tractor.
void TestMachineFile::transportWidth() {
    const auto machine = [](std::string_view more) {
        return parseMachine(
            std::format(
                R"({{"operating_width_m": 12, "raised_width_m": 6, "vehicle_width_m": 2.75, "min_turning_radius_m": 6{}}})",
                more),
            "drill");
    };
    QCOMPARE(machine("").value().transportWidth().si(), 6.0);
    QVERIFY(machine("").value().folded() == machine("").value());
    const Machine folding = machine(R"(, "transport_width_m": 3)").value();
    QCOMPARE(folding.transportWidth().si(), 3.0);
    QCOMPARE(folding.folded().turningWidth().si(), 3.0);
    QCOMPARE(folding.folded().operatingWidth().si(), 12.0);
    QVERIFY(parseMachine(machineJson(folding.spec()), "again").value() == folding);
    QCOMPARE(machine(R"(, "transport_width_m": 2)").value().transportWidth().si(), 2.75);
    for (const char* refused : {"0", "-3", "12.5"}) {
        const auto bad = machine(std::format(R"(, "transport_width_m": {})", refused));
        QVERIFY(!bad);
        QCOMPARE(bad.error().code, ErrorCode::InputRefused);
        QVERIFY(bad.error().where.contains("transport_width_m"));
    }
}

// No time where none is given; up to an hour.
void TestMachineFile::timeToFold() {
    const auto machine = [](std::string_view more) {
        return parseMachine(std::format(R"({{"operating_width_m": 12, "min_turning_radius_m": 6{}}})", more),
                            "drill");
    };
    QCOMPARE(machine("").value().spec().implement.timeToFold.si(), 0.0);
    const Machine folding = machine(R"(, "time_to_fold_s": 45)").value();
    QCOMPARE(folding.spec().implement.timeToFold.si(), 45.0);
    QVERIFY(parseMachine(machineJson(folding.spec()), "again").value() == folding);
    QVERIFY(machine(R"(, "time_to_fold_s": 3600)").has_value());
    for (const char* refused : {"-1", "3601", "\"long\""}) {
        const auto bad = machine(std::format(R"(, "time_to_fold_s": {})", refused));
        QVERIFY(!bad);
        QCOMPARE(bad.error().code, ErrorCode::InputRefused);
        QVERIFY(bad.error().where.contains("time_to_fold_s"));
    }
}

// What folds in reality says so in the library, and how long it takes; nothing is wider on the road than 3.5
// m.
void TestMachineFile::libraryFolds() {
    for (const Machine& machine : machineLibrary()) {
        QVERIFY2(machine.transportWidth() <= metres(3.5), machine.id().c_str());
        const bool takesTime = machine.spec().implement.timeToFold > Duration{};
        QVERIFY2(takesTime == (machine.transportWidth() < machine.turningWidth()), machine.id().c_str());
    }
}

FURROW_TEST(TestMachineFile);
#include "tst_machine_file.moc"
