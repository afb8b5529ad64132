package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CompileTest {

  private static final String LAMP =
      """
      automaton Lamp
      java "lamp.LampAutomaton"
      state on: bool
      start not on
      action switch_on pre not on eff on := true
      """;

  @TempDir private Path folder;

  private Path source;

  @BeforeEach
  void write() throws IOException {
    source = Files.writeString(folder.resolve("lamp.starl"), LAMP);
  }

  @Test
  void javaIsWrittenBelowTheFolder() throws IOException {
    Path java = folder.resolve("java");
    Cli cli = Cli.run("compile", source.toString(), "--java", java.toString());
    assertThat(cli.err()).isEmpty();
    assertThat(cli.status()).isZero();
    assertThat(cli.out())
        .containsExactly(
            "Lamp: 1 actions",
            java.resolve("lamp/LampAction.java").toString(),
            java.resolve("lamp/LampAutomaton.java").toString());
    assertThat(Files.readString(java.resolve("lamp/LampAction.java")))
        .startsWith("// Generated from lamp.starl by 'starl compile'")
        .contains("record switch_on() implements LampAction {}");
  }

  @Test
  void theoryIsWrittenIntoTheFolder() throws IOException {
    Cli cli = Cli.run("compile", source.toString(), "--pvs", folder.toString());
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).containsExactly("Lamp: 1 actions", folder.resolve("Lamp.pvs").toString());
    assertThat(Files.readString(folder.resolve("Lamp.pvs")))
        .contains("Lamp: THEORY", "switch_on: NOT s`on", "END Lamp");
  }

  @Test
  void withoutOptionsASourceIsChecked() {
    Cli cli = Cli.run("compile", source.toString());
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).containsExactly("Lamp: 1 actions");
  }

  @Test
  void everyErrorIsALineAndNothingIsWritten() throws IOException {
    Files.writeString(source, LAMP + "action a eff of := true\naction b pre onn\n");
    Path java = folder.resolve("java");
    Cli cli = Cli.run("compile", source.toString(), "--java", java.toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).hasSize(2);
    assertThat(cli.err().get(0)).startsWith(source + ":6:14: 'of' is no component of the state");
    assertThat(cli.err().get(1)).startsWith(source + ":7:14: 'onn' is not known here");
    assertThat(java).doesNotExist();
  }

  @Test
  void anAutomatonWithoutAClassIsNoJava() throws IOException {
    Files.writeString(source, LAMP.replace("java \"lamp.LampAutomaton\"", ""));
    Cli cli = Cli.run("compile", source.toString(), "--java", folder.toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err())
        .containsExactly(
            source
                + ":1:1: automaton 'Lamp' names no Java class; expected a line: java"
                + " \"a.package.NameAutomaton\"");
  }

  @Test
  void aFileThatIsNotThereIsBadInput() {
    Cli cli = Cli.run("compile", folder.resolve("none.starl").toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).singleElement().asString().contains("cannot be read");
  }
}
