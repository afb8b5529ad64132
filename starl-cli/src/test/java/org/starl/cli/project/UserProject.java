package org.starl.cli.project;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.testkit.engine.EngineTestKit;
import org.junit.platform.testkit.engine.Event;
import org.starl.cli.Cli;
import org.starl.cli.Main;

/** A project that {@code starl new} has written: compiled, tested and run within this JVM. */
final class UserProject {

  private final Path root;
  private final Path classes;

  private UserProject(Path root) {
    this.root = root;
    classes = root.resolve("classes");
  }

  /** Writes it into a new folder. */
  static UserProject written(Path root, String name, String... options) {
    List<String> command = new ArrayList<>(List.of("new", name, "--folder", root.toString()));
    command.addAll(List.of(options));
    Cli cli = Cli.run(command.toArray(String[]::new));
    assertThat(cli.status()).as("%s", cli).isZero();
    return new UserProject(root);
  }

  Path root() {
    return root;
  }

  String text(String file) throws IOException {
    return Files.readString(root.resolve(file));
  }

  /** Replaces a text that occurs once in a file. */
  void edit(String file, String old, String changed) throws IOException {
    String text = text(file);
    assertThat(text).containsOnlyOnce(old);
    Files.writeString(root.resolve(file), text.replace(old, changed));
  }

  /** Compiles it as its own build does, with every warning an error. */
  UserProject compiled() throws IOException {
    writePrograms();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter said = new StringWriter();
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
        Stream<Path> paths = Files.walk(root)) {
      List<String> options = new ArrayList<>(List.of("--release", "21", "-proc:none", "-Werror"));
      options.addAll(List.of("-Xlint:all,-processing,-path", "-d", classes.toString()));
      options.addAll(List.of("-cp", System.getProperty("java.class.path")));
      List<Path> sources = paths.filter(path -> path.toString().endsWith(".java")).toList();
      boolean isGood =
          compiler
              .getTask(said, files, null, options, null, files.getJavaFileObjectsFromPaths(sources))
              .call();
      assertThat(isGood).as("%s", said).isTrue();
    }
    Path services = Files.createDirectories(classes.resolve("META-INF/services"));
    for (String service : List.of("org.starl.apps.Demo", "org.starl.apps.AppFactory")) {
      Files.writeString(
          services.resolve(service), text("src/main/resources/META-INF/services/" + service));
    }
    return this;
  }

  /** Makes Java of its programs, as its builds do. */
  private void writePrograms() throws IOException {
    Path programs = root.resolve("src/main/starl");
    if (Files.isDirectory(programs)) {
      try (Stream<Path> sources = Files.list(programs)) {
        for (Path source : sources.toList()) {
          String folder = root.resolve("target/generated-sources/starl").toString();
          Cli cli = Cli.run("compile", source.toString(), "--java", folder);
          assertThat(cli.status()).as("%s", cli).isZero();
        }
      }
    }
  }

  /** Runs its one test class; returns the messages of its failures. */
  List<String> test(String type) throws IOException {
    try (URLClassLoader loader = loader()) {
      var events =
          EngineTestKit.engine("junit-jupiter")
              .selectors(DiscoverySelectors.selectClass(loader.loadClass(type)))
              .execute()
              .testEvents();
      assertThat(events.started().count()).isPositive();
      List<String> said = new ArrayList<>();
      for (Event event : events.failed().list()) {
        said.add(event.getPayload().orElseThrow().toString());
      }
      return said;
    } catch (ClassNotFoundException e) {
      throw new AssertionError(e);
    }
  }

  /** Runs a command line with its classes on the class path. */
  Cli run(String... args) throws IOException {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader loader = loader()) {
      thread.setContextClassLoader(loader);
      int status = Main.run(new PrintWriter(out), new PrintWriter(err), args);
      return new Cli(status, out.toString().lines().toList(), err.toString().lines().toList());
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  private URLClassLoader loader() throws IOException {
    return new URLClassLoader(
        new URL[] {classes.toUri().toURL()}, UserProject.class.getClassLoader());
  }
}
