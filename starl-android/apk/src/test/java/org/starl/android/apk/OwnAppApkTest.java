package org.starl.android.apk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A project that {@code starl new} has written, in the APK with its app. */
@Tag("long")
class OwnAppApkTest {

  private static final String NAME = "my-robots";
  private static final String FACTORY = "myrobots.MyRobotsFactory";
  private static final String APP = "src/main/java/myrobots/MyRobotsApp.java";
  private static final String CLASS_PATH = System.getProperty("java.class.path");

  @TempDir private Path folder;
  private Path project;
  private Path classes;

  @BeforeEach
  void writeAProject() throws IOException {
    project = folder.resolve(NAME);
    classes = project.resolve("target/classes");
    StringWriter said = new StringWriter();
    PrintWriter printer = new PrintWriter(said);
    int status =
        org.starl.cli.Main.run(printer, printer, "new", NAME, "--folder", project.toString());
    assertThat(status).as("%s", said).isZero();
  }

  /** Compiles it into its folder, resources included; returns the class path of its APK. */
  private String compiled() throws IOException {
    Files.createDirectories(classes);
    StringWriter said = new StringWriter();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
        Stream<Path> paths = Files.walk(project.resolve("src/main/java"))) {
      List<Path> sources = paths.filter(path -> path.toString().endsWith(".java")).toList();
      List<String> options =
          List.of("--release", "21", "-proc:none", "-d", classes.toString(), "-cp", CLASS_PATH);
      boolean isGood =
          compiler
              .getTask(said, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
              .call();
      assertThat(isGood).as("%s", said).isTrue();
    }
    Path services = Files.createDirectories(classes.resolve("META-INF/services"));
    try (Stream<Path> resources =
        Files.list(project.resolve("src/main/resources/META-INF/services"))) {
      for (Path file : resources.toList()) {
        Files.copy(file, services.resolve(file.getFileName().toString()));
      }
    }
    return classes + File.pathSeparator + CLASS_PATH;
  }

  private void edit(String file, String old, String changed) throws IOException {
    String text = Files.readString(project.resolve(file));
    assertThat(text).containsOnlyOnce(old);
    Files.writeString(project.resolve(file), text.replace(old, changed));
  }

  /** The project's own deployment, of its first two robots. */
  private String deploymentOfTwo() throws IOException {
    String text = Files.readString(project.resolve("deployment.yaml"));
    String two = text.replaceAll("(?m)^  bot[23]:.*\n", "");
    assertThat(two).contains("  bot1:").doesNotContain("  bot2:");
    return two;
  }

  private byte[] trace(OwnClasses loader) throws ReflectiveOperationException, IOException {
    Object run = loader.loadClass(OwnAppRun.class.getName()).getConstructor().newInstance();
    // OwnAppRun is a function of this kind.
    @SuppressWarnings("unchecked")
    Function<String, byte[]> traceOf = (Function<String, byte[]>) run;
    return traceOf.apply(deploymentOfTwo());
  }

  @Test
  void theApkHoldsTheAppAndNothingOfItsSimulation() throws ApkException, IOException {
    Selection selection = Selection.of(compiled());
    assertThat(selection.apps())
        .contains(FACTORY, "org.starl.apps.intersection.robot.IntersectionFactory");
    assertThat(selection.own())
        .contains("myrobots/MyRobotsFactory.class", "myrobots/MyRobotsApp.class")
        .doesNotContain("myrobots/MyRobotsDemo.class", "myrobots/AloneAtTheDock.class");
    assertThat(selection.classes().keySet())
        .containsAll(selection.own())
        .noneMatch(name -> name.startsWith("org/starl/sim/") || name.startsWith("java/"))
        .noneMatch(name -> name.matches(".*/(exhaustive/.*|\\w+States.*|SynodRobot.*)"));
    selection.refuseGaps(Android8.shapesBeforeD8(CLASS_PATH));
  }

  @Test
  void dexedCodeOfTheApkRunsADeploymentOfTwoRobots()
      throws ApkException, IOException, ReflectiveOperationException {
    Selection selection = Selection.of(compiled());
    Path services = folder.resolve("services");
    Files.writeString(services, String.join("\n", selection.apps()));
    OwnClasses.Place asCompiled =
        name -> {
          Path own = classes.resolve(name + ".class");
          return Files.exists(own) ? Files.readAllBytes(own) : OwnClasses.compiled(name);
        };
    OwnClasses first = new OwnClasses(asCompiled, services);
    byte[] trace = trace(first);

    SortedMap<String, byte[]> all = new TreeMap<>(selection.classes());
    for (String name : first.needed()) {
      all.putIfAbsent(name + ".class", asCompiled.bytes(name));
    }
    DexedCode dexed = DexedCode.of(all, Files.createDirectory(folder.resolve("dex")));
    OwnClasses returned =
        new OwnClasses(
            name -> {
              byte[] bytes = dexed.classes().get(name);
              boolean isOfTheApk = selection.classes().containsKey(name + ".class");
              return bytes == null && !isOfTheApk && name.startsWith("org/starl/")
                  ? OwnClasses.compiled(name)
                  : bytes;
            },
            services);
    byte[] again = trace(returned);

    assertThat(returned.needed()).contains("myrobots/MyRobotsApp", "myrobots/MyRobotsFactory");
    assertThat(new String(trace, StandardCharsets.UTF_8)).contains("\"value\":\"DONE\"", "bot1");
    assertThat(new String(again, StandardCharsets.UTF_8))
        .isEqualTo(new String(trace, StandardCharsets.UTF_8));
  }

  /** As the project's script does. */
  private String makeApk(Path apk) throws ApkException, IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:TieredStopAtLevel=1", "-Duser.home=" + folder, "-cp", compiled()));
    command.addAll(List.of(Main.class.getName(), "--out", apk.toString()));
    return Tool.run(command);
  }

  @Test
  void aTakenNameIsRefusedInOneLine() throws IOException {
    edit("src/main/java/myrobots/MyRobotsFactory.java", "return \"my-robots\"", "return \"hello\"");
    assertThatThrownBy(() -> makeApk(folder.resolve("a.apk")))
        .isInstanceOf(ApkException.class)
        .hasMessageContaining("ends with status 2: starl: apk: ")
        .hasMessageContaining("its name 'hello' is taken by ");
  }

  @Test
  void oneCommandMakesAnApkThatHoldsTheApp() throws Exception {
    Aapt2 aapt2 = null;
    try {
      aapt2 = Aapt2.find(null);
    } catch (ApkException e) {
      assumeTrue(false, e.getMessage());
    }
    Path apk = project.resolve("out/my-robots.apk");
    String said = makeApk(apk);
    assertThat(said)
        .contains("verified by the signature schemes v2 and v3")
        .contains("apps: hello intersection lightpaint maze my-robots race search");

    assertThat(aapt2.badging(apk))
        .anyMatch(line -> line.startsWith("package: name='org.starl.android.app'"))
        .anyMatch(line -> line.contains("launchable-activity"));
    String file = "AndroidManifest.xml";
    assertThat(
            Tool.run(List.of(aapt2.toString(), "dump", "xmltree", "--file", file, apk.toString())))
        .contains("\".WheelsService\"", "\":wheels\"");
    try (ZipFile zip = new ZipFile(apk.toFile())) {
      byte[] services =
          zip.getInputStream(zip.getEntry("META-INF/services/org.starl.apps.AppFactory"))
              .readAllBytes();
      assertThat(new String(services, StandardCharsets.UTF_8).lines())
          .contains(FACTORY, "org.starl.apps.hello.robot.HelloFactory");
      List<String> inDex = new ArrayList<>();
      for (String dex : List.of("classes.dex", "classes2.dex")) {
        if (zip.getEntry(dex) != null) {
          byte[] bytes = zip.getInputStream(zip.getEntry(dex)).readAllBytes();
          inDex.add(new String(bytes, StandardCharsets.ISO_8859_1));
        }
      }
      assertThat(String.join("", inDex))
          .contains("Lmyrobots/MyRobotsFactory;", "Lmyrobots/MyRobotsApp;")
          .contains("Lorg/starl/android/app/WheelsService;")
          .doesNotContain("Lmyrobots/MyRobotsDemo;", "Lorg/starl/sim/Simulation;");
    }
  }

  @Test
  void anAppThatNeedsTheSimulatorIsRefusedInOneLine() throws IOException {
    edit(APP, "int made = 0;", "int made = org.starl.sim.SimSettings.defaults().robots() * 0;");
    String classPath = compiled();
    assertThatThrownBy(() -> Selection.of(classPath))
        .isInstanceOf(ApkException.class)
        .hasMessage(
            "myrobots.MyRobotsApp uses org.starl.sim.SimSettings, which no phone has; expected core,"
                + " input and primitives only");
  }

  @Test
  void anAppThatNeedsANewerAndroidIsRefusedInOneLine() throws ApkException, IOException {
    edit(APP, "List.of(\"visits: \" + made)", "List.of(List.of(\"visits: \" + made).getFirst())");
    Selection selection = Selection.of(compiled());
    SortedMap<String, Links.Shape> android8 = Android8.shapesBeforeD8(CLASS_PATH);
    assertThatThrownBy(() -> selection.refuseGaps(android8))
        .isInstanceOf(ApkException.class)
        .hasMessage(
            "Android 8 lacks: myrobots/MyRobotsApp -> java/util/List.getFirst()Ljava/lang/Object;");
  }

  /** As DexedCodeTest finds it in the dexed code. */
  @Test
  void theCheckBeforeD8FindsWhatIsMissingAfterIt() throws ApkException, IOException {
    SortedMap<String, byte[]> named = new TreeMap<>();
    Selection.of(CLASS_PATH)
        .classes()
        .forEach((file, bytes) -> named.put(file.replace(".class", ""), bytes));
    List<String> starls = named.keySet().stream().filter(n -> n.startsWith("org/starl/")).toList();
    assertThat(Links.missing(named, starls, Android8.shapesBeforeD8(CLASS_PATH)))
        .hasSize(1)
        .allMatch(missing -> missing.contains("RobotService.startForeground("));
  }

  @Test
  void aServiceWithoutItsClassIsRefusedInOneLine() throws IOException {
    String classPath = compiled();
    Files.writeString(classes.resolve(Selection.SERVICES), "myrobots.Missing # gone\n");
    assertThatThrownBy(() -> Selection.of(classPath))
        .isInstanceOf(ApkException.class)
        .hasMessage(
            "META-INF/services/org.starl.apps.AppFactory: myrobots.Missing: expected a class");
  }
}
