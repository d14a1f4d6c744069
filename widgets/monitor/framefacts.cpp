// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/framefacts.h"

namespace mb {

const FrameMeaning *FrameFacts::meaning() const
{
    if (m_said)
        return m_said;
    if (!m_looked && m_record.isFrame())
        m_meaning = m_decoder.decode(m_record.frame);
    if (!m_looked && m_meaning && m_asked)
        m_meaning->frame.address = *m_asked;
    m_looked = true;
    return m_meaning ? &*m_meaning : nullptr;
}

} // namespace mb
