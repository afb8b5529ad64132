package org.starl.cli.project;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion.VersionFlag;
import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.Version;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;

/** A project of {@code starl new} compiles, passes its test, and does as its README says. */
@Tag("long")
class NewCommandTest {

  private static final String NAME = "my-robots";
  private static final String APP = "src/main/java/myrobots/MyRobotsApp.java";
  private static final String TEST = "src/test/java/myrobots/MyRobotsTest.java";
  private static final String TEST_CLASS = "myrobots.MyRobotsTest";

  @TempDir private static Path folder;

  private static UserProject project;
  private static String readme;

  @BeforeAll
  static void writeAndCompile() throws IOException {
    project = UserProject.written(folder.resolve(NAME), NAME).compiled();
    readme = project.text("README.md");
  }

  /** The code blocks of the tour, in their order. */
  private static List<String> blocks() {
    return Pattern.compile("```java\n(.*?)```", Pattern.DOTALL)
        .matcher(readme)
        .results()
        .map(match -> match.group(1))
        .toList();
  }

  private static String fault() {
    Matcher fault = Pattern.compile("--fault '([^']+)'").matcher(readme);
    assertThat(fault.find()).isTrue();
    return fault.group(1);
  }

  /** Another copy, to change. */
  private static UserProject copy(Path temporary) {
    return UserProject.written(temporary.resolve(NAME), NAME);
  }

  private static void breakIt(UserProject copy) throws IOException {
    String release = blocks().get(2).strip();
    copy.edit(APP, "            " + release + "\n", "");
    String home = "            gvh.plat.moat.doMove(home);\n";
    copy.edit(APP, home, "            " + release + "\n" + home);
    copy.compiled();
  }

  @Test
  void itsTestPasses() throws IOException {
    assertThat(project.test(TEST_CLASS)).isEmpty();
  }

  @Test
  void itsCommandLineRunsItsAppAndKnowsAllOthers(@TempDir Path out) throws IOException {
    Cli run = project.run("run", NAME, "--seed", "7", "--png", out.resolve("a.png").toString());
    assertThat(run.status()).as("%s", run).isZero();
    assertThat(run.text()).contains("bot3: visits: 2", "4 of 4 robots", "alone_at_the_dock");
    Cli list = project.run("list");
    assertThat(list.out())
        .contains("app my-robots: robots take turns at a dock")
        .anyMatch(line -> line.startsWith("  visits=2 "))
        .anyMatch(line -> line.startsWith("app intersection: "));
    assertThat(project.run("list", NAME).out())
        .anyMatch(line -> line.startsWith("  lemma alone_at_the_dock: No two robots "));
    Cli bad = project.run("run", NAME, "--set", "visits=0");
    assertThat(bad.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(project.run("verify-determinism", NAME, "--seed", "7").status()).isZero();
  }

  @Test
  void itBringsTheMavenWrapper() throws IOException {
    Path wrapper = folder.resolve(NAME).resolve("mvnw");
    assertThat(wrapper).isExecutable().hasSameTextualContentAs(Path.of("../mvnw"));
    assertThat(project.text(".mvn/wrapper/maven-wrapper.properties"))
        .contains("distributionSha256Sum=");
    assertThat(project.text(NAME)).contains("maven=$root/mvnw");
  }

  @Test
  void itsScenarioIsValidForEditorsAndCommands() throws IOException {
    String schema = project.run("schema").text();
    assertThat(
            JsonSchemaFactory.getInstance(VersionFlag.V7)
                .getSchema(new ObjectMapper().readTree(schema))
                .validate(new YAMLMapper().readTree(project.text("scenario.yaml"))))
        .isEmpty();
    String file = project.root().resolve("scenario.yaml").toString();
    Cli campaign = project.run("campaign", file, "--seeds", "1..5");
    assertThat(campaign.status()).as("%s", campaign).isZero();
  }

  /** Gradle may run on a JDK that cannot load StarL; a task of its own would use that one. */
  @Test
  void gradleRunsStarlOnTheJdkThatCompilesIt() throws IOException {
    String build = project.text("build.gradle.kts");
    assertThat(build).contains("JavaExec>");
    assertThat(build.substring(build.indexOf("toolchain.languageVersion.set(")))
        .contains(
            """
                tasks.withType<JavaExec>().configureEach {
                    javaLauncher.set(javaToolchains.launcherFor(java.toolchain))
                }
            """);
  }

  @Test
  void itsTheoryHasTheLocationsOfItsAppAndTheGuardOfItsTour() throws IOException {
    String theory = project.text("dock.pvs");
    assertThat(names(theory, "Location: TYPE = \\{([^}]*)}"))
        .isNotEmpty()
        .isEqualTo(names(project.text(APP), "enum Location \\{([^}]*)}"));
    Matcher guard = Pattern.compile("```\n(AND .*)\n```").matcher(readme);
    assertThat(guard.find()).isTrue();
    assertThat(theory).containsOnlyOnce(guard.group(1));
  }

  /** The names of a theory's parameters. */
  private static List<String> parameters(String theory) {
    Matcher head = Pattern.compile("(?s)\n\\w+ \\[(.*?)]: THEORY").matcher(theory);
    assertThat(head.find()).isTrue();
    return Pattern.compile("(\\w+): (?:\\[.*?]|\\w+)")
        .matcher(head.group(1))
        .results()
        .map(found -> found.group(1))
        .toList();
  }

  private static List<String> names(String text, String pattern) {
    Matcher list = Pattern.compile(pattern).matcher(text);
    assertThat(list.find()).isTrue();
    return List.of(list.group(1).strip().split("\\s*,\\s*"));
  }

  @Test
  void itsDeploymentIsValid(@TempDir Path temporary) throws IOException {
    UserProject copy = copy(temporary).compiled();
    String file = copy.root().resolve("deployment.yaml").toString();
    Cli keygen = copy.run("keygen", copy.root().resolve(NAME + ".key").toString());
    assertThat(keygen.status()).as("%s", keygen).isZero();
    Cli check = copy.run("deploy", "check", file);
    assertThat(check.status()).as("%s", check).isZero();
    assertThat(check.text()).contains("no problem found");
  }

  @Test
  void theChangeOfTheTourIsCorrectAndFaster(@TempDir Path temporary) throws IOException {
    UserProject changed = copy(temporary);
    changed.edit(APP, blocks().get(0), blocks().get(1));
    changed.compiled();
    assertThat(changed.test(TEST_CLASS)).isEmpty();
    Cli slow = changed.run("campaign", NAME, "--seeds", "1..20", "--fault", fault(), "--json");
    assertThat(slow.status()).as("%s", slow).isZero();
    Cli before = project.run("campaign", NAME, "--seeds", "1..3", "--json");
    Cli after = changed.run("campaign", NAME, "--seeds", "1..3", "--json");
    assertThat(endSeconds(after)).isLessThan(0.9 * endSeconds(before));
  }

  private static double endSeconds(Cli campaign) throws IOException {
    return new ObjectMapper().readTree(campaign.text()).path("end_s_p50").asDouble();
  }

  @Test
  void theBugOfTheTourIsFoundAsDescribed(@TempDir Path temporary) throws IOException {
    UserProject broken = copy(temporary);
    breakIt(broken);
    assertThat(broken.test(TEST_CLASS)).isEmpty();
    Cli campaign = broken.run("campaign", NAME, "--seeds", "1..10", "--fault", fault());
    assertThat(campaign.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(campaign.err().toString()).contains("alone_at_the_dock violated");
    broken.edit(TEST, blocks().get(4).strip(), blocks().get(3).strip());
    broken.compiled();
    assertThat(broken.test(TEST_CLASS)).hasSize(1).allMatch(why -> why.contains("-Dstarl.seed="));
  }

  @Test
  void theFixOfTheTourStaysCorrect(@TempDir Path temporary) throws IOException {
    UserProject mended = copy(temporary);
    mended.edit(TEST, blocks().get(4).strip(), blocks().get(3).strip());
    mended.compiled();
    assertThat(mended.test(TEST_CLASS)).isEmpty();
  }

  @Test
  void anAppWithATakenNameIsRefusedInOneLine(@TempDir Path temporary) throws IOException {
    UserProject other = copy(temporary);
    other.edit("src/main/java/myrobots/MyRobotsFactory.java", "return \"" + NAME, "return \"hello");
    other.compiled();
    Cli cli = other.run("list");
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err())
        .containsExactly(
            "starl: myrobots.MyRobotsDemo: its name 'hello' is taken; expected another");
  }

  @Test
  void aProjectWithAProgramIsSimulatedExploredAndProvedAsItsReadmeSays(@TempDir Path temporary)
      throws IOException {
    UserProject programs = UserProject.written(temporary.resolve(NAME), NAME, "--starl").compiled();
    assertThat(programs.test(TEST_CLASS)).isEmpty();
    Cli run = programs.run("run", NAME, "--seed", "7");
    assertThat(run.status()).as("%s", run).isZero();
    assertThat(run.text()).contains("4 of 4 robots", "alone_at_the_dock");
    String program = "src/main/starl/MyRobotsApp.starl";
    String file = programs.root().resolve(program).toString();
    String sizes = "--size Zones=1 --size Places=1 --nat 1 --robots 2";
    assertThat(programs.text("README.md")).contains("check " + program + " " + sizes + "\n");
    List<String> check = new ArrayList<>(List.of("check", file));
    check.addAll(List.of(sizes.split(" ", -1)));
    Cli checked = programs.run(check.toArray(String[]::new));
    assertThat(checked.status()).as("%s", checked).isZero();
    Cli compiled = programs.run("compile", file, "--pvs", programs.root().toString());
    assertThat(compiled.status()).as("%s", compiled).isZero();
    String proof = programs.text("MyRobotsApp_safety.pvs");
    assertThat(names(proof, "IMPORTING MyRobotsApp\\[([^\\]]*)]"))
        .isEqualTo(parameters(programs.text("MyRobotsApp.pvs")))
        .isEqualTo(parameters(proof));
    Matcher change =
        Pattern.compile(
                "write\n\n    (when .*)\n\n.*\n\n((    .*\n)+)\nIn `drive_out` take `(.*)` out")
            .matcher(programs.text("README.md"));
    assertThat(change.find()).isTrue();
    programs.edit(program, "when moat.done do moat.do_move(home); goto drive_out", change.group(1));
    programs.edit(program, "location drive_out\n", change.group(2) + "\nlocation drive_out\n");
    programs.edit(program, change.group(4) + " made", "made");
    Cli broken = programs.run(check.toArray(String[]::new));
    assertThat(broken.status()).as("%s", broken).isEqualTo(ExitStatus.VIOLATED);
    assertThat(broken.text()).contains("Asks is false after");
  }

  @Test
  void aProgramInKotlinIsRefusedInOneLine(@TempDir Path empty) throws IOException {
    String folder = empty.resolve("x").toString();
    Cli cli = Cli.run("new", NAME, "--starl", "--kotlin", "--folder", folder);
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err())
        .containsExactly("starl: --starl: expected no --kotlin beside it; its builds make Java");
    assertThat(empty).isEmptyDirectory();
  }

  @Test
  void itsManifestForAndroidStudioIsThatOfStarlsApk() throws IOException {
    String starls =
        Files.readString(
            Path.of(
                "../starl-android/app/src/main/resources/org/starl/android/app/apk/AndroidManifest.xml"));
    assertThat(project.text("phone/src/main/AndroidManifest.xml"))
        .isEqualTo(
            starls
                .replace("<!-- docs/android.md", "<!-- StarL's docs/android.md")
                .replace("\n    package=\"org.starl.android.app\"", "")
                .replace("android:name=\".", "android:name=\"org.starl.android.app.")
                .replace("@string/app_name", NAME)
                .replace("      android:icon=\"@drawable/icon\"\n", ""));
    String rules = "res/xml/data_extraction_rules.xml";
    assertThat(project.text("phone/src/main/" + rules))
        .isEqualTo(
            Files.readString(
                Path.of(
                    "../starl-android/app/src/main/resources/org/starl/android/app/apk/" + rules)));
  }

  @Test
  void theLauncherIsExecutable() {
    assertThat(Files.isExecutable(project.root().resolve(NAME))).isTrue();
  }

  @Test
  void theLauncherFindsAJdkAsStarlDoes() throws IOException {
    assertThat(findingAJdk(project.text(NAME)))
        .isNotEmpty()
        .isEqualTo(findingAJdk(Files.readString(Path.of("../starl"))));
  }

  @Test
  void theLauncherGivesJavaTheOptionsThatStarlGives() throws IOException {
    assertThat(project.text(NAME))
        .contains("options='" + ProjectTemplate.javaOptions("robot") + "'")
        .contains("options='" + ProjectTemplate.javaOptions("simulation") + "'")
        .contains("options='" + ProjectTemplate.javaOptions("campaign") + "'");
    assertThat(ProjectTemplate.javaOptions("robot")).contains(" -Xms16m ");
  }

  private static String findingAJdk(String script) {
    int from = script.indexOf("# --- the JDK ");
    return script.substring(from, script.indexOf("# --- the build ", from));
  }

  @Test
  void theLastLinesNameEveryStepToAGreenTest(@TempDir Path temporary) throws IOException {
    Path repository = Files.createDirectory(temporary.resolve("repository"));
    assertThat(lastLines(repository, temporary.resolve("one")))
        .anyMatch(line -> line.startsWith("first: ./starl install "))
        .contains("next: cd " + temporary.resolve("one"))
        .anyMatch(line -> line.startsWith("      mvn test "));
    Files.createDirectories(repository.resolve("org/starl/starl-cli/" + Version.STARL));
    assertThat(lastLines(repository, temporary.resolve("two")))
        .noneMatch(line -> line.contains("install"))
        .contains("next: cd " + temporary.resolve("two"));
  }

  private static List<String> lastLines(Path repository, Path project) {
    String before = System.getProperty(NewCommand.REPOSITORY);
    System.setProperty(NewCommand.REPOSITORY, repository.toString());
    try {
      return Cli.run("new", NAME, "--folder", project.toString()).out();
    } finally {
      if (before == null) {
        System.clearProperty(NewCommand.REPOSITORY);
      } else {
        System.setProperty(NewCommand.REPOSITORY, before);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "Rover",
        "2d",
        "a--b",
        "a-",
        "a_b",
        "class",
        "fun",
        "java",
        "hello",
        "mutex",
        "aaaaaaaaaabbbbbbbbbbccccccccccdddddddddde",
        "räuber"
      })
  void anInvalidNameIsRefusedInOneLine(String name, @TempDir Path empty) throws IOException {
    Cli cli = Cli.run("new", name, "--folder", empty.resolve("x").toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).hasSize(1);
    assertThat(cli.err().get(0)).startsWith("starl: '" + name + "': ").contains("expected a");
    assertThat(empty).isEmptyDirectory();
  }

  @Test
  void anExistingFolderIsLeftUnchanged(@TempDir Path there) throws IOException {
    Files.writeString(there.resolve("mine"), "mine");
    for (Path taken : List.of(there, there.resolve("mine"), there.resolve("no/where"))) {
      Cli cli = Cli.run("new", NAME, "--folder", taken.toString());
      assertThat(cli.status()).isEqualTo(ExitStatus.BAD_INPUT);
      assertThat(cli.err()).hasSize(1);
      assertThat(cli.err().get(0)).contains("expected a");
    }
    try (Stream<Path> children = Files.list(there)) {
      assertThat(children).containsExactly(there.resolve("mine"));
    }
  }

  @Test
  void anEmptyFolderIsUsed(@TempDir Path empty) throws IOException {
    assertThat(Cli.run("new", NAME, "--folder", empty.toString()).status()).isZero();
    assertThat(empty.resolve("pom.xml")).exists();
  }

  @Test
  void aPathIsTheFolderAndEndsWithTheName(@TempDir Path there) {
    assertThat(Cli.run("new", there.resolve("a-b").toString()).status()).isZero();
    assertThat(Cli.run("new", there.resolve("c-d") + "/").status()).isZero();
    assertThat(there.resolve("a-b/a-b")).isExecutable();
    assertThat(there.resolve("c-d/src/main/java/cd")).isDirectory();
    Cli twice = Cli.run("new", there.resolve("e").toString(), "--folder", "f");
    assertThat(twice.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(twice.err())
        .containsExactly("starl: --folder f: expected none beside the path " + there.resolve("e"));
    Cli unnamed = Cli.run("new", there + "/..");
    assertThat(unnamed.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(unnamed.err().get(0)).startsWith("starl: '..': expected a name");
  }

  @Test
  void itsVersionsAreThoseOfTheBuild() throws IOException {
    Properties words = new Properties();
    Path template = Path.of("src/main/resources/org/starl/cli/project/words.properties");
    try (Reader reader = Files.newBufferedReader(template)) {
      words.load(reader);
    }
    String catalog = Files.readString(Path.of("../gradle/libs.versions.toml"));
    String pom = Files.readString(Path.of("../pom.xml"));
    words.remove("fault");
    assertThat(words).hasSizeGreaterThan(7);
    words.forEach((key, version) -> {
      if (key.toString().startsWith("maven-")) {
        assertThat(pom)
            .containsPattern(
                "<artifactId>" + key + "</artifactId>\\s*<version>" + version + "</version>");
      } else {
        assertThat(catalog).contains("\n" + key + " = \"" + version + "\"\n");
      }
    });
  }
}
