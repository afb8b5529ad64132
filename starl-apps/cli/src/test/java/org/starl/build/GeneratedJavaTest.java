package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.lang.java.JavaSources;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The automata in Java are those of their sources. */
class GeneratedJavaTest {

  private static final String JAVA = "starl-primitives/src/main/java/";

  private final Repository repository = Repository.here();

  static Stream<String> sources() {
    return Repository.here().textFiles().stream()
        .map(SourceFile::path)
        .filter(path -> path.endsWith(".starl"));
  }

  @ParameterizedTest
  @MethodSource("sources")
  void generatedFilesAreThoseOfTheirSource(String file) throws IOException, SourceErrors {
    for (Automaton automaton : new SourceReader().read(repository.file(file))) {
      if (automaton.javaClass().isEmpty()) {
        continue;
      }
      for (Map.Entry<String, String> each : JavaSources.of(automaton, file).entrySet()) {
        assertThat(repository.text(JAVA + each.getKey()))
            .as("%s: generate it again: starl compile %s --java %s", each.getKey(), file, JAVA)
            .isEqualTo(each.getValue());
      }
    }
  }
}
