package org.starl.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads the Gradle scripts and the version catalog. It knows the few forms that they are written in,
 * and refuses a line that it does not know, rather than miss a dependency.
 */
final class GradleBuild {

  /** Maven's test plugin brings this by itself. */
  static final String GRADLE_ALONE = "org.junit.platform:junit-platform-launcher";

  /** Settings that take the modules from the pom, each named after its folder. */
  private static final Pattern FROM_POM =
      Pattern.compile(
          "Regex\\(\"<module>\\(\\.\\+\\)</module>\"\\)\\.findAll\\(rootDir\\.resolve\\(\"pom\\.xml\"\\)");

  private static final Pattern MODULE = Pattern.compile("<module>(.+)</module>");
  private static final Pattern ASSIGNED = Pattern.compile("\\s*(group|version) = \"([^\"]+)\"");
  private static final Pattern RELEASE = Pattern.compile("options\\.release\\.set\\((\\d+)\\)");
  private static final Pattern VERSION = Pattern.compile("([\\w-]+) = \"([^\"]+)\"");
  private static final Pattern LIBRARY =
      Pattern.compile("([\\w-]+) = \\{ module = \"([^\"]+)\", version\\.ref = \"([^\"]+)\" \\}");
  private static final Pattern DEPENDENCIES = Pattern.compile("(?ms)^dependencies \\{\\n(.*?)^\\}");

  /** Configurations of tools of the build. */
  private static final Set<String> TOOLS = Set.of("antlr", "annotationProcessor");

  private static final Pattern DEPENDENCY =
      Pattern.compile(
          "(\\w+)\\((?:project\\(\":([\\w-]+)\"\\)|libs\\.([\\w.]+)"
              + "|variantOf\\(libs\\.([\\w.]+)\\) \\{ artifactType\\(\"(\\w+)\"\\) \\})\\)");
  private static final Pattern KOTLIN = Pattern.compile("kotlin\\(\"jvm\"\\) version \"([^\"]+)\"");

  private final SortedMap<String, String> versions = new TreeMap<>();

  /** By the accessor that scripts use: {@code junit.jupiter} for {@code junit-jupiter}. */
  private final SortedMap<String, String[]> libraries = new TreeMap<>();

  private GradleBuild(String catalog) {
    String section = "";
    for (String line : catalog.lines().map(String::strip).toList()) {
      if (line.isEmpty() || line.startsWith("#")) {
        continue;
      }
      if (line.startsWith("[")) {
        section = line;
      } else if (section.equals("[versions]")) {
        Matcher version = match(VERSION, line);
        versions.put(version.group(1), version.group(2));
      } else if (section.equals("[libraries]")) {
        Matcher library = match(LIBRARY, line);
        String version = versions.get(library.group(3));
        if (version == null) {
          throw new IllegalStateException("no version " + library.group(3) + " in: " + line);
        }
        libraries.put(library.group(1).replace('-', '.'), new String[] {library.group(2), version});
      } else {
        throw new IllegalStateException("unknown section " + section + " in the version catalog");
      }
    }
  }

  /**
   * @param files gives the text of a file of the project
   */
  static Build read(UnaryOperator<String> files) {
    return new GradleBuild(files.apply("gradle/libs.versions.toml")).build(files);
  }

  private Build build(UnaryOperator<String> files) {
    String script = files.apply("build.gradle.kts");
    SortedMap<String, String> own = new TreeMap<>();
    Matcher assigned = ASSIGNED.matcher(script);
    while (assigned.find()) {
      own.put(assigned.group(1), assigned.group(2));
    }
    Matcher release = RELEASE.matcher(script);
    if (!release.find()) {
      throw new IllegalStateException("build.gradle.kts sets no options.release");
    }
    TreeSet<String> modules = new TreeSet<>();
    List<Dependency> dependencies = new ArrayList<>();
    if (!FROM_POM.matcher(files.apply("settings.gradle.kts")).find()) {
      throw new IllegalStateException(
          "settings.gradle.kts does not include the modules of pom.xml");
    }
    Matcher module = MODULE.matcher(files.apply("pom.xml"));
    while (module.find()) {
      modules.add(module.group(1));
      if (!module.group(1).equals(Build.BOM)) {
        addDependencies(dependencies, module.group(1), own, files);
      }
    }
    requireKotlin(files.apply("starl-core/kotlin/build.gradle.kts"));
    requireKotlin(files.apply("starl-apps/kotlin/build.gradle.kts"));
    String coordinates = own.get("group") + ":" + own.get("version");
    return new Build(coordinates, release.group(1), modules, versions, dependencies);
  }

  /** The plugin has the version of the library. */
  private void requireKotlin(String script) {
    Matcher plugin = KOTLIN.matcher(script);
    if (!plugin.find() || !plugin.group(1).equals(versions.get("kotlin"))) {
      throw new IllegalStateException(
          "Kotlin's plugin is not of version " + versions.get("kotlin"));
    }
  }

  private void addDependencies(
      List<Dependency> found,
      String module,
      SortedMap<String, String> own,
      UnaryOperator<String> files) {
    Matcher block = DEPENDENCIES.matcher(files.apply(module + "/build.gradle.kts"));
    if (!block.find()) {
      throw new IllegalStateException(module + " has no dependencies block");
    }
    for (String line : block.group(1).lines().map(String::strip).toList()) {
      if (line.isEmpty() || line.startsWith("//")) {
        continue;
      }
      Matcher dependency = match(DEPENDENCY, line);
      if (TOOLS.contains(dependency.group(1))) {
        continue; // Maven has them as plugins
      }
      String scope = scope(dependency.group(1));
      if (dependency.group(2) != null) {
        String needed = own.get("group") + ":" + dependency.group(2);
        found.add(new Dependency(module, needed, own.get("version"), scope));
        continue;
      }
      boolean isVariant = dependency.group(4) != null;
      String[] library = libraries.get(dependency.group(isVariant ? 4 : 3));
      if (library == null) {
        throw new IllegalStateException("no library for: " + line);
      }
      if (!library[0].equals(GRADLE_ALONE)) {
        String needed = library[0] + (isVariant ? "@" + dependency.group(5) : "");
        found.add(new Dependency(module, needed, library[1], scope));
      }
    }
  }

  private static String scope(String configuration) {
    return switch (configuration) {
      case "api", "implementation" -> "compile";
      case "compileOnly" -> "provided";
      case "runtimeOnly" -> "runtime";
      case "testImplementation", "testRuntimeOnly" -> "test";
      default -> throw new IllegalStateException("unknown configuration " + configuration);
    };
  }

  private static Matcher match(Pattern pattern, String line) {
    Matcher matcher = pattern.matcher(line);
    if (!matcher.matches()) {
      throw new IllegalStateException("not understood: " + line);
    }
    return matcher;
  }
}
