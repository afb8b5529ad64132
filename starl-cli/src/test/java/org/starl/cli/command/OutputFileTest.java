package org.starl.cli.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Cli;

/** A file appears whole or not at all. */
class OutputFileTest {

  @TempDir private Path folder;

  private static void write(Path path, String text) throws IOException {
    try (OutputFile file = new OutputFile("--out", path.toString())) {
      file.stream().write(text.getBytes(StandardCharsets.UTF_8));
    }
  }

  @Test
  void aFileAppearsWhenClosed() throws IOException {
    Path path = folder.resolve("new/a.txt");
    try (OutputFile file = new OutputFile("--out", path.toString())) {
      file.stream().write('x');
      assertThat(path).doesNotExist();
    }
    assertThat(path).hasContent("x");
    write(path, "other");
    assertThat(path).hasContent("other");
    try (Stream<Path> all = Files.list(path.resolveSibling("."))) {
      assertThat(all).hasSize(1);
    }
  }

  @Test
  void withoutOutputTheFileStaysUnchanged() throws IOException {
    Path old = Files.writeString(folder.resolve("old.txt"), "old");
    write(old, "");
    assertThat(old).hasContent("old");
    write(folder.resolve("none.txt"), "");
    assertThat(folder.resolve("none.txt")).doesNotExist();
  }

  @Test
  void aLinkIsWrittenThrough() throws IOException {
    Path old = Files.writeString(folder.resolve("old.txt"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link"), old);
    write(link, "new");
    assertThat(old).hasContent("new");
    assertThat(link).isSymbolicLink();
  }

  @Test
  void aDeviceStaysADevice() throws IOException {
    Path device = Path.of("/dev/null");
    assumeTrue(Files.isWritable(device), "skipped: no /dev/null here");
    write(device, "text");
    assertThat(Files.isRegularFile(device)).isFalse();
    assertThat(device).exists();
  }

  @Test
  void aFullDeviceIsToldByEachClose() throws IOException {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.isWritable(full), "skipped: no /dev/full here");
    OutputFile file = new OutputFile("--out", full.toString());
    file.stream().write(new byte[100_000]);
    assertThatThrownBy(file.stream()::close).hasMessageContaining("--out: '/dev/full'");
    assertThatThrownBy(file::close).hasMessageContaining("cannot be written (No space left");
  }

  @Tag("realtime")
  @Test
  void leavesNoEmptyFolder() throws Exception {
    Path picture = folder.resolve("new/er/a.png");
    List<String> words =
        Cli.process("record", "hello", "--seed", "1", "--when", "violation", "--out", "" + picture);
    Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
    try (BufferedReader out = process.inputReader()) {
      assertThat(out.lines()).anyMatch(line -> line.contains("no specification was violated"));
    }
    assertThat(process.waitFor()).isZero();
    assertThat(folder).isEmptyDirectory();
  }
}
