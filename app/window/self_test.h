#pragma once

class QQuickWindow;

namespace furrow {

class Session;

/// From now on warnings of Qt and QML are counted; one of them fails the self-test.
void countMessages();

/// Goes through every state and page of the window without network or files of the user, prints what it did,
/// and ends the program: status 0, or 1 where something did not appear.
void runSelfTest(QQuickWindow& window, Session& session);

}  // namespace furrow
