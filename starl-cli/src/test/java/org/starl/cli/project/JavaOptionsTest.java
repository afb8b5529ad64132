package org.starl.cli.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The options that {@code ./starl} gives to Java: in a folder with the files that a build leaves. */
@Tag("realtime")
class JavaOptionsTest {

  private static final String OPTIONS = "starl-cli/src/main/resources/org/starl/cli/jvm/";
  private static final String PRINT_WORDS = "#!/bin/sh\nprintf '%s\\n' \"LC_ALL=$LC_ALL\" \"$@\"\n";

  @TempDir private Path folder;

  private int seconds;

  private String locale = "C";

  /** Each file is newer than those before it. */
  private void file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    // The launcher makes its cache in the background: a program that runs cannot be written.
    Path written = folder.resolve("written");
    Files.writeString(written, text);
    assertThat(written.toFile().setExecutable(true)).isTrue();
    Files.setLastModifiedTime(written, FileTime.fromMillis(1000L * ++seconds));
    Files.move(written, file, StandardCopyOption.REPLACE_EXISTING);
  }

  /** The words that Java gets for a command line. */
  private List<String> words(String userOptions, String... line)
      throws IOException, InterruptedException {
    file("starl", Files.readString(Path.of("../starl")));
    for (String kind : List.of("robot", "simulation", "campaign")) {
      String options = OPTIONS + kind + ".config";
      file(options, Files.readString(Path.of("..", options)));
    }
    file("pom.xml", "    <module>starl-apps/kotlin</module>\n");
    file("jdk/release", "JAVA_VERSION=\"25\"\n");
    file("jdk/bin/javac", "");
    file("jdk/bin/java", PRINT_WORDS);
    file("bin/mvn", "");
    file("starl-apps/kotlin/target/run/begun", "");
    file("starl-apps/kotlin/target/run/classpath.txt", folder.resolve("pom.xml").toString());
    file("target/starl-maven/starl.jar", "");
    ProcessBuilder builder = new ProcessBuilder(folder.resolve("starl").toString());
    builder.command().addAll(List.of(line));
    builder.environment().remove("STARL_JAVA");
    builder.environment().put("LC_ALL", locale);
    builder.environment().put("JAVA_HOME", folder.resolve("jdk").toString());
    builder.environment().put("STARL_JAVA_OPTS", userOptions);
    builder.environment().merge("PATH", folder + "/bin", (old, mine) -> mine + ":" + old);
    Process process = builder.redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(out).isZero();
    assertThat(out.lines()).endsWith(line);
    return out.lines().flatMap(JavaOptionsTest::inFile).toList();
  }

  /** A word, or, as Java has it, those of the file that it names. */
  private static Stream<String> inFile(String word) {
    if (!word.startsWith("@")) {
      return Stream.of(word);
    }
    try {
      return Files.readAllLines(Path.of(word.substring(1))).stream()
          .filter(line -> !line.startsWith("#"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aSimulationHasTheParallelCollectorAndLateCompilation() throws Exception {
    assertThat(words("-Xmx1g", "run", "hello"))
        .contains("-XX:+UseParallelGC", "-XX:Tier4InvocationThreshold=25000", "-Xmx1g");
    assertThat(words("-Xmx1g", "deploy", "merge", "bot0.trace")).contains("-XX:+UseParallelGC");
  }

  @Test
  void aCampaignHasASmallYoungGenerationUnlessTheUserSizesTheHeap() throws Exception {
    for (List<String> line :
        List.of(List.of("campaign", "race"), List.of("sweep", "a.yaml"), List.of("bench", "b5"))) {
      String[] words = line.toArray(new String[0]);
      assertThat(words("-Da=b", words))
          .contains("-XX:InlineSmallCode=300")
          .anyMatch(word -> word.matches("-Xmn\\d+m"));
      for (String sized :
          List.of("-Xmx1g", "-XX:MaxHeapSize=1g", "-XX:MaxRAMPercentage=50", "-XX:+UseZGC")) {
        assertThat(words(sized, words))
            .contains("-XX:InlineSmallCode=300")
            .noneMatch(word -> word.startsWith("-Xmn"));
      }
    }
    assertThat(words("-Da=b", "bench", "b1"))
        .doesNotContain("-XX:InlineSmallCode=300")
        .noneMatch(word -> word.startsWith("-Xmn"));
  }

  @Test
  void aCollectorOfTheUserReplacesOnlyTheCollector() throws Exception {
    assertThat(words("-XX:+UseZGC", "run", "hello"))
        .contains("-XX:Tier4InvocationThreshold=25000", "-XX:+UseZGC")
        .doesNotContain("-XX:+UseParallelGC");
    assertThat(words("-XX:+UseGCOverheadLimit -Da=b", "run", "hello"))
        .contains("-XX:+UseParallelGC");
    assertThat(words("-XX:+UseZGC", "deploy", "run", "crossing.yaml"))
        .contains("-XX:TieredStopAtLevel=1", "-XX:+UseZGC")
        .doesNotContain("-XX:+UseSerialGC");
  }

  @Test
  void aRobotHasASmallHeapAndLeavesTheProcessorToOthers() throws Exception {
    for (List<String> line :
        List.of(
            List.of("deploy", "run", "crossing.yaml"),
            List.of("deploy", "world", "crossing.yaml"),
            List.of("simulated-create", "--pty", "create0"))) {
      assertThat(words("-Xmx1g", line.toArray(new String[0])))
          .contains("-XX:+UseSerialGC", "-Xms16m", "-XX:TieredStopAtLevel=1", "-Xmx1g")
          .doesNotContain("-XX:+UseTransparentHugePages");
    }
  }

  @Test
  void javaCanNameFilesOfAllAlphabets() throws Exception {
    assertThat(words("", "run", "hello")).contains("LC_ALL=C.UTF-8");
    locale = "POSIX";
    assertThat(words("", "run", "hello")).contains("LC_ALL=C.UTF-8");
    locale = "C.utf8";
    assertThat(words("", "run", "hello")).contains("LC_ALL=C.utf8");
  }
}
