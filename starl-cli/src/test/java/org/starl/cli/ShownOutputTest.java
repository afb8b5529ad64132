package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The pages show what commands print: the lines below {@code $ ./starl ...}, and the lines of a trace.
 * Three dots stand for lines, or for a part of a line, that are left out: everything that depends on the machine is.
 */
class ShownOutputTest {

  private static final Path ROOT = Path.of("..");
  private static final Pattern SHOWN =
      Pattern.compile("(?m)^    \\$ \\./starl (.*)\n((?:    (?!\\$ ).*\n)+)");
  private static final Pattern WORD = Pattern.compile("'([^']*)'|\\S+");

  /** Pages and commands that are not run here, and why. */
  private static final Map<String, String> NOT_RUN =
      Map.of(
          "language.md", "its automata are files of the reader; CheckTest and ProveTest run them",
          "your-own-app.md", "NewCommandTest makes the project",
          "your-own-program.md", "the same",
          "explore mutex --seed 1 --robots 3 --strategy random",
              "a mutex that is broken on purpose");

  private record Shown(String page, String command, List<String> lines) {
    boolean isLong() {
      return command.startsWith("campaign mutex") || command.contains("--strategy states");
    }

    @Override
    public String toString() {
      return page + ": " + command;
    }
  }

  private static List<Shown> shown(boolean isLong) throws IOException {
    List<Path> pages = new ArrayList<>(List.of(ROOT.resolve("README.md")));
    try (Stream<Path> files = Files.walk(ROOT.resolve("docs"))) {
      files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(pages::add);
    }
    List<Shown> all = new ArrayList<>();
    for (Path page : pages) {
      String name = page.getFileName().toString();
      SHOWN
          .matcher(Files.readString(page))
          .results()
          .map(each -> new Shown(name, each.group(1), lines(each)))
          .filter(each -> !NOT_RUN.containsKey(name) && !NOT_RUN.containsKey(each.command()))
          .filter(each -> each.isLong() == isLong)
          .forEach(all::add);
    }
    return all;
  }

  private static List<String> lines(MatchResult block) {
    return block.group(2).lines().map(line -> line.substring(4)).toList();
  }

  static List<Shown> quick() throws IOException {
    return shown(false);
  }

  static List<Shown> slow() throws IOException {
    return shown(true);
  }

  private static Cli run(String command, String... more) {
    Stream<String> words =
        WORD.matcher(command)
            .results()
            .map(word -> word.group(1) == null ? word.group() : word.group(1));
    return Cli.run(Stream.concat(words, Arrays.stream(more)).toArray(String[]::new));
  }

  /** A line of three dots stands for any lines; so a pattern of all lines. */
  private static Pattern pattern(List<String> lines) {
    return Pattern.compile(
        lines.stream()
            .map(line -> line.strip().equals("...") ? "(?:.*\n)*" : pattern(line) + "\n")
            .collect(Collectors.joining()));
  }

  private static String pattern(String line) {
    return Arrays.stream(line.split("\\.\\.\\.", -1))
        .map(Pattern::quote)
        .collect(Collectors.joining(".*"));
  }

  private static void check(Shown shown) {
    String printed = run(shown.command()).text() + "\n";
    assertThat(pattern(shown.lines()).matcher(printed).find())
        .as("%s shows%n%s%nand the command prints%n%s", shown, shown.lines(), printed)
        .isTrue();
  }

  @ParameterizedTest
  @MethodSource("quick")
  void theLinesAreThoseThatTheCommandPrints(Shown shown) {
    check(shown);
  }

  @Tag("long")
  @ParameterizedTest
  @MethodSource("slow")
  void theLinesAreThoseThatALongCommandPrints(Shown shown) {
    check(shown);
  }

  @Test
  void theLinesOfTheTraceFormatAreOfItsRun(@TempDir Path folder) throws IOException {
    String page = Files.readString(ROOT.resolve("docs/trace-format.md"));
    MatchResult command =
        Pattern.compile("(?m)^    \\./starl (run .* --trace) (\\S+)$")
            .matcher(page)
            .results()
            .findFirst()
            .orElseThrow();
    Path file = folder.resolve(command.group(2));
    run(command.group(1), file.toString());
    String trace = "\n" + Files.readString(file);
    List<String> shown =
        Pattern.compile("(?m)^\\{\"kind\":.*$")
            .matcher(page)
            .results()
            .map(MatchResult::group)
            // These are of no run of the command line: the app that writes a note is the reader's.
            .filter(line -> !line.contains("{\"note\":") && !line.contains("\"intervention\""))
            .toList();
    assertThat(shown).hasSizeGreaterThan(10);
    assertThat(shown)
        .allSatisfy(line -> assertThat(trace).containsPattern("\n" + pattern(line) + "\n"));
  }
}
