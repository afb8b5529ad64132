package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.lang.java.JavaSources;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The automata and programs in Java are those of their sources. */
class GeneratedJavaTest {

  private final Repository repository = Repository.here();

  static Stream<String> sources() {
    return Repository.here().textFiles().stream()
        .map(SourceFile::path)
        .filter(path -> path.endsWith(".starl"));
  }

  @ParameterizedTest
  @MethodSource("sources")
  void generatedFilesAreThoseOfTheirSource(String file) throws IOException, SourceErrors {
    Source source = new SourceReader().source(repository.file(file));
    Map<String, String> files = new TreeMap<>();
    if (!source.programs().isEmpty()) {
      files.putAll(JavaSources.of(source, file));
    }
    for (Automaton automaton : source.automata()) {
      if (!automaton.javaClass().isEmpty()) {
        files.putAll(JavaSources.of(automaton, file));
      }
    }
    String folder = folder(file);
    for (Map.Entry<String, String> each : files.entrySet()) {
      assertThat(repository.text(folder + each.getKey()))
          .as("%s: generate it again: starl compile %s --java %s", each.getKey(), file, folder)
          .isEqualTo(each.getValue());
    }
  }

  /**
   * A program is beside the Java of its module; the automata in {@code pvs} are the primitives', but
   * for the intersection.
   */
  private static String folder(String file) {
    if (file.equals("pvs/starl/Traffic_decls.starl")) {
      return "starl-apps/src/main/java/";
    }
    return file.startsWith("pvs/")
        ? "starl-primitives/src/main/java/"
        : file.replaceFirst("/src/main/starl/.*", "/src/main/java/");
  }
}
