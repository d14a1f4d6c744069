// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picturesaver.h"

#include <QRunnable>

namespace mb {

PictureSaver::PictureSaver(Write write)
    : m_write(std::move(write))
{
    m_pool.setMaxThreadCount(1);
}

PictureSaver::~PictureSaver()
{
    m_pool.waitForDone();
}

void PictureSaver::save(const QImage &picture, const QString &path)
{
    ++m_waiting;
    m_pool.start(QRunnable::create([this, picture, path] {
        if (!m_write(picture, path))
            m_good = false;
        --m_waiting;
    }));
}

bool PictureSaver::finish()
{
    m_pool.waitForDone();
    return m_good;
}

} // namespace mb
