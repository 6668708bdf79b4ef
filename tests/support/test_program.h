#pragma once

#include <QCoreApplication>
#include <QTest>

#include <string_view>

namespace furrow {

/// A test of a program that holds several. The program runs the one whose name it is called by: each has a
/// link of its own beside the program, named after its source.
class TestInProgram {
public:
    using Run = int (*)(int argc, char** argv);

    TestInProgram(std::string_view sourceFile, Run run);
};

template <class Test, class Application>
int runTest(int argc, char** argv) {
    const Application application{argc, argv};
    // As QTEST_MAIN does: the same size of text everywhere.
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

}  // namespace furrow

// At the end of a test's source, in the place of QTEST_MAIN. FURROW_TEST has no window.
#define FURROW_TEST_WITH(Test, Application)          \
    static const furrow::TestInProgram kInProgram {  \
        __FILE__, furrow::runTest<Test, Application> \
    }
#define FURROW_TEST(Test) FURROW_TEST_WITH(Test, QCoreApplication)
