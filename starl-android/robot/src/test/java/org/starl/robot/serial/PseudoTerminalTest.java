package org.starl.robot.serial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.robot.create.StreamLink;

@Tag("realtime")
class PseudoTerminalTest {

  @TempDir private Path folder;

  @Test
  void anExistingFileIsNotReplaced() throws IOException {
    Path name = Files.writeString(folder.resolve("port"), "mine");
    assertThatThrownBy(() -> PseudoTerminal.open(name.toString()))
        .isInstanceOf(IOException.class)
        .hasMessage("no pseudo terminal " + name + ": File exists");
    assertThat(name).hasContent("mine");
  }

  @Test
  void anEarlierLinkIsReplaced() throws IOException {
    String name = folder.resolve("port").toString();
    try (StreamLink first = PseudoTerminal.open(name);
        StreamLink second = PseudoTerminal.open(name)) {
      assertThat(second.name()).isEqualTo(first.name());
    }
  }

  @Test
  void aClosedTerminalLeavesTheNameToALaterOne() throws IOException {
    Path name = folder.resolve("port");
    StreamLink first = PseudoTerminal.open(name.toString());
    try (StreamLink second = PseudoTerminal.open(name.toString())) {
      Path terminal = Files.readSymbolicLink(name);
      assertThatCode(first::close).doesNotThrowAnyException();
      assertThat(name).isSymbolicLink();
      assertThat(Files.readSymbolicLink(Path.of(second.name()))).isEqualTo(terminal);
    }
  }

  @Test
  void aClosedTerminalHasNoName() throws IOException {
    Path name = folder.resolve("port");
    PseudoTerminal.open(name.toString()).close();
    assertThat(name).doesNotExist();
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void aMissingFolderIsReported() {
    assertThatThrownBy(() -> PseudoTerminal.open(folder.resolve("no/port").toString()))
        .hasMessageEndingWith(": No such file or directory");
  }
}
