package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.cli.command.ExitStatus;

/** The command lines in the comments of shipped files have the commands and options that exist. */
class ShippedCommentsTest {

  private static final Path ROOT = Path.of("..");
  private static final Path TEMPLATE =
      ROOT.resolve("starl-cli/src/main/resources/org/starl/cli/project");

  /** Words for people follow after two spaces or more. */
  private static final Pattern COMMAND =
      Pattern.compile("#.*?(?:\\./)?(?:starl|@name@) ((?:\\S+ )*\\S+)(?:  .*)?");

  /** A command line, in a file. */
  record Shown(Path file, String words) {
    @Override
    public String toString() {
      return file.getFileName() + ": " + words;
    }
  }

  static List<Shown> shown() throws IOException {
    List<Shown> shown = new ArrayList<>();
    try (Stream<Path> shipped = Files.walk(ROOT.resolve("scenarios"));
        Stream<Path> template = Files.walk(TEMPLATE)) {
      List<Path> files =
          Stream.concat(shipped, template)
              .filter(file -> file.toString().matches(".*\\.yaml(\\.txt)?"))
              .sorted()
              .toList();
      for (Path file : files) {
        for (String line : Files.readAllLines(file)) {
          Matcher command = COMMAND.matcher(line);
          if (command.matches() && line.matches("# {3,}.*")) {
            shown.add(new Shown(file, command.group(1)));
          }
        }
      }
    }
    return shown;
  }

  /** What the command line does not know, without running it: the last word makes it refuse. */
  private static String unknown(String words) {
    Cli cli = Cli.run((words + " --unknown-word").split(" "));
    assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.BAD_INPUT);
    return cli.err().get(0);
  }

  @ParameterizedTest
  @MethodSource("shown")
  void eachCommandIsOne(Shown shown) {
    assertThat(unknown(shown.words())).contains("starl: '--unknown-word': ");
  }

  @ParameterizedTest
  @MethodSource("shown")
  void itsFilesExist(Shown shown) {
    for (String word : shown.words().split(" ")) {
      if (word.endsWith(".yaml")) {
        Path beside = shown.file().resolveSibling(Path.of(word).getFileName());
        assertThat(List.of(beside, ROOT.resolve(word), Path.of(beside + ".txt")))
            .as(word)
            .anyMatch(Files::exists);
      }
    }
  }

  @Test
  void anOptionThatDoesNotExistWouldBeFound() throws IOException {
    assertThat(unknown("deploy run crossing.yaml --robot bot0 --trace bot0.trace"))
        .contains("'--trace'");
    assertThat(shown()).hasSizeGreaterThan(12);
  }
}
