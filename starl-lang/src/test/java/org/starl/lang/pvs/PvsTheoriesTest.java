package org.starl.lang.pvs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The theories in {@code pvs/} that are made of sources. */
class PvsTheoriesTest {

  private static final Path PVS = root().resolve("pvs");

  private static Path root() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("settings.gradle.kts"))) {
      folder = folder.getParent();
    }
    return folder;
  }

  static List<Path> sources() throws IOException {
    Path programs = PVS.resolveSibling("starl-apps").resolve("src/main/starl");
    try (Stream<Path> primitives = Files.list(PVS.resolve("starl"));
        Stream<Path> apps = Files.list(programs)) {
      return Stream.concat(primitives, apps)
          .filter(file -> file.toString().endsWith(".starl"))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("sources")
  void keptTheoriesAreThoseOfTheirSource(Path source) throws IOException, SourceErrors {
    List<Automaton> automata = new SourceReader().read(source);
    assertThat(source).hasFileName(automata.getLast().name() + ".starl");
    String from = PVS.relativize(source).toString();
    for (Automaton automaton : automata) {
      String name = automaton.name() + ".pvs";
      Path made = Files.createDirectories(Path.of("target/pvs")).resolve(name);
      String theory = PvsTheory.of(automaton, from);
      Files.writeString(made, theory);
      assertThat(Files.readString(PVS.resolve(name)))
          .as("pvs/%s: the source makes another one: %s", name, made)
          .isEqualTo(theory);
    }
  }
}
