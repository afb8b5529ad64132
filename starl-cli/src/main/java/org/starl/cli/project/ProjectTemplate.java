package org.starl.cli.project;

import java.io.IOException;
import java.io.StringReader;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Properties;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.Version;
import org.starl.input.TextFile;

/**
 * The files of a user's own project, from resources beside this class. In a template {@code @word@}
 * stands for a word. A line that consists of {@code @part@} stands for a part: whole lines, which
 * may differ between languages or be empty.
 */
final class ProjectTemplate {

  /** The template of the executable file. */
  private static final String LAUNCHER = "launcher";

  private static final String SERVICES = "src/main/resources/META-INF/services/org.starl.apps.";
  private static final String JAVA_OPTIONS = "/org/starl/cli/jvm/";
  private static final String SUFFIX = ".txt";
  private static final String JAVA = "java/";
  private static final String WORDS = "words.properties";
  private static final Pattern WORD = Pattern.compile("@([A-Za-z-]+)@");
  private static final Pattern PART = Pattern.compile("@([a-z-]+)@\n", Pattern.MULTILINE);

  private final Map<String, String> words = new LinkedHashMap<>();
  private final String language;

  /**
   * @param text of the file
   * @param isProgram whether it is executable
   */
  record Written(String text, boolean isProgram) {}

  /**
   * @param name of the project: lower-case letters and digits, with single dashes between
   * @param language java or kotlin; or starl, for Java with a program in StarL's language
   */
  ProjectTemplate(String name, String language) {
    this.language = language;
    addWords(WORDS);
    if (isProgram()) {
      addWords(JAVA + WORDS);
    }
    addWords(language + "/" + WORDS);
    words.put("name", name);
    words.put("Name", className(name));
    words.put("package", packageName(name));
    words.put("starl", Version.STARL);
    for (String kind : List.of("robot", "simulation", "campaign")) {
      words.put(kind + "-options", javaOptions(kind));
    }
  }

  /** Those of {@code ./starl}, which reads them from the same file. */
  static String javaOptions(String kind) {
    String file = read(JAVA_OPTIONS + kind + ".config");
    if (file == null) {
      throw new IllegalStateException("no options of Java for " + kind);
    }
    return file.lines().filter(line -> !line.startsWith("#")).collect(Collectors.joining(" "));
  }

  /** {@code my-robots} as a package. */
  static String packageName(String name) {
    return name.replace("-", "");
  }

  private static String className(String name) {
    return Stream.of(name.split("-"))
        .map(part -> Character.toUpperCase(part.charAt(0)) + part.substring(1))
        .collect(Collectors.joining());
  }

  /** Every file of the project, by its path with slashes. */
  Map<String, Written> files() {
    Map<String, Written> files = new LinkedHashMap<>();
    put(files, "README.md", isProgram() ? own("README.md") : "README.md");
    put(files, "pom.xml", "pom.xml");
    put(files, "build.gradle.kts", own("build.gradle.kts"));
    put(files, "settings.gradle.kts", "settings.gradle.kts");
    put(files, ".gitignore", "gitignore");
    put(files, ".github/workflows/starl.yml", "github.yml");
    put(files, ".gitlab-ci.yml", "gitlab-ci.yml");
    put(files, "scenario.yaml", "scenario.yaml");
    put(files, "deployment.yaml", "deployment.yaml");
    if (isProgram()) {
      put(files, "src/main/starl/@Name@App.starl", own("App.starl"));
      put(files, "@Name@App_safety.pvs", own("App_safety.pvs"));
      put(files, "@sources@/Dock.java", own("Dock.java"));
    } else {
      put(files, "dock.pvs", "dock.pvs");
      put(files, "@sources@/@Name@App.@ext@", own("App.@ext@"));
    }
    put(files, "@name@", LAUNCHER);
    wrap(files, "mvnw", true);
    wrap(files, ".mvn/wrapper/maven-wrapper.properties", false);
    for (String file : List.of("settings.gradle.kts", "build.gradle.kts")) {
      put(files, "phone/" + file, "phone/" + file);
    }
    put(files, "phone/src/main/AndroidManifest.xml", "phone/AndroidManifest.xml");
    String rules = "data_extraction_rules.xml";
    put(files, "phone/src/main/res/xml/" + rules, "phone/" + rules);
    put(files, SERVICES + "Demo", "demo-service");
    put(files, SERVICES + "AppFactory", "factory-service");
    for (String part : List.of("Factory", "Demo", "Main")) {
      put(files, "@sources@/@Name@" + part + ".@ext@", own(part + ".@ext@"));
    }
    put(files, "@sources@/AloneAtTheDock.@ext@", own("AloneAtTheDock.@ext@"));
    put(files, "@tests@/@Name@Test.@ext@", own("Test.@ext@"));
    return files;
  }

  private boolean isProgram() {
    return language.equals("starl");
  }

  /** The resource of the language; beside a program, of Java where the program needs no other. */
  private String own(String resource) {
    String its = withWords(language + "/" + resource);
    return isProgram() && read(its + SUFFIX) == null ? withWords(JAVA + resource) : its;
  }

  private void put(Map<String, Written> files, String path, String resource) {
    String template = read(withWords(resource) + SUFFIX);
    if (template == null) {
      throw new IllegalStateException("no template " + resource);
    }
    String whole = PART.matcher(template).replaceAll(part -> Matcher.quoteReplacement(part(part)));
    files.put(withWords(path), new Written(withWords(whole), resource.equals(LAUNCHER)));
  }

  /** A file of the Maven wrapper: StarL's own, as it is. */
  private static void wrap(Map<String, Written> files, String path, boolean isProgram) {
    files.put(path, new Written(Objects.requireNonNull(read(path), path), isProgram));
  }

  /** The lines of a part; the line itself if it is a word. */
  private String part(MatchResult line) {
    if (words.containsKey(line.group(1))) {
      return line.group();
    }
    String text = read(own(line.group(1)) + SUFFIX);
    return text == null ? "" : text;
  }

  /**
   * @throws IllegalStateException if a word is unknown
   */
  private String withWords(String text) {
    return WORD.matcher(text)
        .replaceAll(match -> {
          String word = words.get(match.group(1));
          if (word == null) {
            throw new IllegalStateException("a template has the unknown word " + match.group());
          }
          return Matcher.quoteReplacement(withWords(word));
        });
  }

  private void addWords(String resource) {
    Properties properties = new Properties();
    try {
      properties.load(new StringReader(TextFile.resource(ProjectTemplate.class, resource)));
    } catch (IOException e) {
      throw new IllegalStateException(resource, e);
    }
    properties.stringPropertyNames().forEach(key -> words.put(key, properties.getProperty(key)));
  }

  private static @Nullable String read(String path) {
    return ProjectTemplate.class.getResource(path) == null
        ? null
        : TextFile.resource(ProjectTemplate.class, path);
  }
}
