// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a tour are packed beside the thread of the window, which renews the lease of what moves.
#include "app/picturesaver.h"
#include "support/windowtests.h"

#include <QSemaphore>
#include <QThread>

using namespace mb;

class TestPictureSaver : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theWindowGoesOnWhileAPictureIsPacked();
    void allAreWrittenInTheirOrderBeforeItEnds();
    void oneThatCannotBeWrittenIsTold();
};

void TestPictureSaver::theWindowGoesOnWhileAPictureIsPacked()
{
    QSemaphore mayEnd;
    QThread *packing = QThread::currentThread();
    PictureSaver saver([&](const QImage &, const QString &) {
        packing = QThread::currentThread();
        return mayEnd.tryAcquire(1, 60'000);
    });
    saver.save(QImage(8, 8, QImage::Format_RGB32), QStringLiteral("a.png"));
    QCOMPARE(saver.waiting(), 1); // it came back, although nothing lets it end yet
    mayEnd.release();
    QVERIFY(saver.finish());
    QCOMPARE(saver.waiting(), 0);
    QVERIFY(packing != QThread::currentThread());
}

void TestPictureSaver::allAreWrittenInTheirOrderBeforeItEnds()
{
    QStringList written;
    PictureSaver saver([&written](const QImage &picture, const QString &path) {
        written << path + QString::number(picture.width());
        return true;
    });
    for (int i = 1; i < 20; ++i)
        saver.save(QImage(i, 1, QImage::Format_RGB32), QStringLiteral("p"));
    QVERIFY(saver.finish());
    QCOMPARE(written.size(), 19);
    for (int i = 1; i < 20; ++i)
        QCOMPARE(written.at(i - 1), QStringLiteral("p%1").arg(i));
}

void TestPictureSaver::oneThatCannotBeWrittenIsTold()
{
    PictureSaver saver([](const QImage &, const QString &path) { return path != QStringLiteral("bad"); });
    saver.save(QImage(1, 1, QImage::Format_RGB32), QStringLiteral("bad"));
    saver.save(QImage(1, 1, QImage::Format_RGB32), QStringLiteral("good"));
    QVERIFY(!saver.finish());
}

MB_WINDOW_TEST(TestPictureSaver);
#include "tst_picturesaver.moc"
