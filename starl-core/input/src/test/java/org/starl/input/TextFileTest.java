package org.starl.input;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class TextFileTest {

  private static final String EXPECTED = "expected a poem";

  @TempDir private Path folder;

  private Path file(byte... bytes) throws IOException {
    return Files.write(folder.resolve("a.txt"), bytes);
  }

  @Test
  void aByteOrderMarkIsLeftOut() throws IOException {
    Path marked = file((byte) 0xEF, (byte) 0xBB, (byte) 0xBF, (byte) 'r', (byte) 0xC3, (byte) 0xB6);
    assertThat(TextFile.read(marked, EXPECTED)).isEqualTo("r\u00F6");
    assertThat(TextFile.read(file(), EXPECTED)).isEmpty();
  }

  @Test
  void errorsNameTheFileAndWhatWasExpected() throws IOException {
    refuses(folder, "is a folder");
    refuses(folder.resolve("none"), "no such file");
    refuses(file((byte) 0xF6), "is not text");
    refuses(file((byte) 'a', (byte) 0), "is not text");
  }

  /** A device may have no end, and a pipe without a writer blocks its reader for ever. */
  @Test
  void onlyRegularFilesAreRead() {
    refuses(Path.of("/dev/zero"), "is not a regular file");
    refuses(Path.of("/dev/null"), "is not a regular file");
  }

  private static void refuses(Path file, String why) {
    assertThatThrownBy(() -> TextFile.read(file, EXPECTED))
        .isInstanceOf(BadInput.class)
        .hasMessage(file + ": " + why + "; " + EXPECTED);
  }
}
