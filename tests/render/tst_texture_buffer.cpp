// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "render/texture_buffer.h"
#include "tests/render/offscreen.h"

#include <numeric>
#include <vector>

using namespace trixel::render;

namespace {

constexpr std::size_t kBytes = 4;

std::vector<std::uint32_t> numbered(std::size_t count)
{
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 1U);
    return numbers;
}

std::vector<std::uint32_t> read(Gl& gl, TextureBuffer& buffer)
{
    std::vector<std::uint32_t> read(buffer.size());
    GLint name = 0;
    buffer.bind(0);
    gl.glGetTexLevelParameteriv(GL_TEXTURE_BUFFER, 0, GL_TEXTURE_BUFFER_DATA_STORE_BINDING, &name);
    gl.glBindBuffer(GL_TEXTURE_BUFFER, static_cast<GLuint>(name));
    gl.glGetBufferSubData(
        GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(kBytes * read.size()), read.data());
    return read;
}

} // namespace

class TestTextureBuffer : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void keepsWhatIsWrittenAsItGrows_data() { memories(); }
    void keepsWhatIsWrittenAsItGrows();
    void holdsWhatItIsFilledWithWhateverWasThere_data() { memories(); }
    void holdsWhatItIsFilledWithWhateverWasThere();
    void takesOurMemoryWhereTheDriverClearsAllItGives();
    void leavesNoErrorsBehind();

private:
    static void memories();

    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Gl> m_gl;
};

void TestTextureBuffer::init()
{
    m_gl.reset();
    m_offscreen = std::make_unique<Offscreen>(16, 16);
    QVERIFY(m_offscreen->isValid());
    m_offscreen->bind();
    m_gl = currentGl();
}

void TestTextureBuffer::memories()
{
    QTest::addColumn<bool>("mapped");
    QTest::newRow("the driver's") << false;
    QTest::newRow("our own") << true;
}

void TestTextureBuffer::keepsWhatIsWrittenAsItGrows()
{
    QFETCH(bool, mapped);
    if (mapped && !takesMappedMemory(*m_gl)) {
        QSKIP("Another driver");
    }
    TextureBuffer buffer(
        *m_gl, GL_R32UI, kBytes, mapped ? BufferMemory::Mapped : BufferMemory::Drivers);
    const auto first = numbered(1000);
    buffer.allocate(3000);
    buffer.write(500, std::as_bytes(std::span(first)));
    buffer.grow(3'000'000);
    buffer.write(2'999'000, std::as_bytes(std::span(first)));
    buffer.copy(500, 1'000'000, 1000);
    const auto found = read(*m_gl, buffer);
    QCOMPARE(found.size(), std::size_t{3'000'000});
    for (const std::size_t at :
         {std::size_t{500}, std::size_t{1'000'000}, std::size_t{2'999'000}}) {
        QVERIFY(std::equal(first.begin(), first.end(), found.begin() + std::ptrdiff_t(at)));
    }
}

void TestTextureBuffer::holdsWhatItIsFilledWithWhateverWasThere()
{
    QFETCH(bool, mapped);
    if (mapped && !takesMappedMemory(*m_gl)) {
        QSKIP("Another driver");
    }
    TextureBuffer buffer(
        *m_gl, GL_R32UI, kBytes, mapped ? BufferMemory::Mapped : BufferMemory::Drivers);
    for (const std::size_t count :
         {std::size_t{100'000}, std::size_t{7}, std::size_t{0}, std::size_t{2'000'000}}) {
        const auto numbers = numbered(count);
        buffer.fill(std::as_bytes(std::span(numbers)));
        QCOMPARE(buffer.size(), count);
        QVERIFY(read(*m_gl, buffer) == numbers);
    }
}

/// Figures of Mesa's rasteriser are measured with it: a driver without it would be slower
/// unnoticed.
void TestTextureBuffer::takesOurMemoryWhereTheDriverClearsAllItGives()
{
    const QByteArray name(reinterpret_cast<const char*>(m_gl->glGetString(GL_RENDERER)));
    QCOMPARE(takesMappedMemory(*m_gl), name.startsWith("llvmpipe"));
}

void TestTextureBuffer::leavesNoErrorsBehind()
{
    {
        TextureBuffer buffer(*m_gl, GL_R32UI, kBytes);
        buffer.fill({});
        buffer.allocate(1U << 20U);
        buffer.grow(1U << 21U);
    }
    QCOMPARE(m_gl->glGetError(), GLenum{GL_NO_ERROR});
}

QTEST_MAIN(TestTextureBuffer)
#include "tst_texture_buffer.moc"
