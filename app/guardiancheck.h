// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProcess;
class QPushButton;

namespace mb {

/// Whether the process that stops a motor when this program cannot is there and runs on this computer: asked by a button, said in a line
/// and to screen readers. GUI thread.
class GuardianCheck : public QWidget {
    Q_OBJECT
public:
    /// `program`: its path.
    explicit GuardianCheck(const QString &program, QWidget *parent = nullptr);
    void check();

private:
    void say(const QString &words, bool good);

    QString m_program;
    QLabel *m_words = nullptr;
    QPushButton *m_ask = nullptr;
    QProcess *m_process = nullptr;
};

} // namespace mb
