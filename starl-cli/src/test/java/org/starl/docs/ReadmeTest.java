package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What {@code README.md} shows is what is compiled and tested. */
class ReadmeTest {

  private static final Path ROOT = Path.of("..");
  private static final String HELLO = "java/org/starl/apps/hello/";
  private static final Pattern JAVA = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

  static Stream<Arguments> shown() {
    return Stream.of(
        Arguments.of("Hello", Path.of("../starl-apps/src/main/" + HELLO + "logic/Hello.java")),
        Arguments.of("HelloTest", Path.of("../starl-apps/src/test/" + HELLO + "HelloTest.java")));
  }

  private static String readme() throws IOException {
    return Files.readString(ROOT.resolve("README.md"));
  }

  private static String withoutSpace(String code) {
    return code.replaceAll("\\s+", "");
  }

  @ParameterizedTest
  @MethodSource("shown")
  void theCodeIsTheOneThatRuns(String type, Path file) throws IOException {
    List<String> blocks =
        JAVA.matcher(readme())
            .results()
            .map(match -> match.group(1))
            .filter(block -> block.contains("class " + type + " "))
            .toList();
    assertThat(blocks).hasSize(1);
    assertThat(withoutSpace(Files.readString(file))).contains(withoutSpace(blocks.get(0)));
  }
}
