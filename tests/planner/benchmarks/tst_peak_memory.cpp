// The peak is that of the work alone, whatever was used and freed before it.

#include "planner/benchmarks/peak_memory.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstring>
#include <memory>
#include <vector>

using namespace furrow;

namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

/// Takes as much in blocks of this size, writes to all of it, and gives it back.
void use(std::size_t bytes, std::size_t block) {
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t taken = 0; taken < bytes; taken += block) {
        blocks.push_back(std::make_unique_for_overwrite<char[]>(block));
        std::memset(blocks.back().get(), static_cast<int>(taken % 251), block);
    }
}

}  // namespace

class PeakMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("the sanitiser keeps what is freed");
#endif
        if (!peakMemoryOf([] {})) {
            QSKIP("this system does not tell");
        }
    }

    void whatIsUsedIsCounted_data() {
        QTest::addColumn<int>("mebibytes");
        QTest::addColumn<int>("block");
        QTest::addColumn<int>("usedBeforeMiB");
        QTest::newRow("nothing") << 0 << 4096 << 0;
        QTest::newRow("one large block") << 64 << 64 * static_cast<int>(kMiB) << 0;
        QTest::newRow("many small blocks") << 64 << 1024 << 0;
        QTest::newRow("less than was freed before") << 32 << 1024 << 96;
        QTest::newRow("nothing after much") << 0 << 4096 << 96;
    }
    void whatIsUsedIsCounted() {
        QFETCH(int, mebibytes);
        QFETCH(int, block);
        QFETCH(int, usedBeforeMiB);
        const auto bytes = static_cast<std::size_t>(mebibytes) * kMiB;
        use(static_cast<std::size_t>(usedBeforeMiB) * kMiB, 1024);
        const auto peak = peakMemoryOf([&] { use(bytes, static_cast<std::size_t>(block)); });
        QVERIFY(peak.has_value());
        // An allocator's own notes on a block of a kilobyte take 16 bytes, those of this test 8.
        const QByteArray told = QByteArray::number(*peak);
        QVERIFY2(*peak >= bytes - bytes / 50, told);
        QVERIFY2(*peak <= bytes + bytes / 10 + 2 * kMiB, told);
    }
};

FURROW_TEST(PeakMemoryTest);
#include "tst_peak_memory.moc"
