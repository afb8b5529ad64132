package org.starl.cli.project;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.Version;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Shell;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code starl new}. */
@Command(
    name = "new",
    description =
        "Creates a project of your own in a new folder: an app, its scenario, a monitor, a test,"
            + " builds for Maven and Gradle, and a guided tour.",
    footer = {"", "Example: starl new my-robots"})
public final class NewCommand extends BaseCommand implements Callable<Integer> {

  /** Maven's property for another local repository. */
  static final String REPOSITORY = "maven.repo.local";

  private static final int LONGEST_NAME = 40;
  private static final Pattern NAME = Pattern.compile("[a-z][a-z0-9]*(-[a-z0-9]+)*");

  /** Reserved words of Java and Kotlin: no package can have such a name. */
  private static final Set<String> RESERVED =
      Set.of(
          ("abstract as assert boolean break byte case catch char class const continue default do"
                  + " double else enum extends false final finally float for fun goto if implements"
                  + " import in instanceof int interface is java javax kotlin long native new null"
                  + " object package private protected public return short static strictfp super"
                  + " switch synchronized this throw throws transient true try typealias typeof val"
                  + " var void volatile when while")
              .split(" "));

  @Parameters(
      index = "0",
      paramLabel = "NAME",
      description =
          "Name of the project, its folder and its app, such as my-robots; or a path that ends with"
              + " it, such as ../my-robots.")
  private String name = "";

  @Option(
      names = "--folder",
      paramLabel = "FOLDER",
      description = "The new folder (default: NAME, in the current folder).")
  private @Nullable String folder;

  @Option(names = "--kotlin", description = "Use Kotlin instead of Java.")
  private boolean isKotlin;

  @Option(
      names = "--starl",
      description = "Begin with a program in StarL's language, of which the builds make Java.")
  private boolean isProgram;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = out();
    takePath();
    check(demos().names());
    if (isProgram && isKotlin) {
      throw new BadInput("--starl: expected no --kotlin beside it; its builds make Java");
    }
    Map<String, ProjectTemplate.Written> files =
        new ProjectTemplate(name, isProgram ? "starl" : isKotlin ? "kotlin" : "java").files();
    String shown = folder == null ? name : folder;
    write(Path.of(shown).toAbsolutePath().normalize(), shown, files);
    out.println(shown + ": " + files.size() + " files");
    files.keySet().forEach(path -> out.println("  " + path));
    if (!isInstalled()) {
      out.println(
          "first: ./starl install          # in StarL's folder: once, and after each change of"
              + " StarL");
    }
    out.printf(
        """
        next: cd %s
              mvn test                  # or: gradle test
              ./%s run %s --seed 7
        then read README.md: a tour of half an hour
        """,
        Shell.quote(shown), name, name);
    return ExitStatus.GOOD;
  }

  /** Divides a path into the folder and its last part, the name. */
  private void takePath() {
    String path = name.replaceFirst("[/" + Pattern.quote(File.separator) + "]+$", "");
    int nameAt = Math.max(path.lastIndexOf('/'), path.lastIndexOf(File.separatorChar)) + 1;
    if (nameAt > 0 && folder != null) {
      throw new BadInput("--folder " + folder + ": expected none beside the path " + name);
    }
    folder = nameAt > 0 ? path : folder;
    name = path.substring(nameAt);
  }

  /** Whether the local Maven repository has the libraries of this version. */
  private static boolean isInstalled() {
    String usual = System.getProperty("user.home") + "/.m2/repository";
    String repository = System.getProperty(REPOSITORY, usual);
    return Files.isDirectory(Path.of(repository, "org/starl/starl-cli", Version.STARL));
  }

  private void check(List<String> apps) {
    if (name.length() > LONGEST_NAME || !NAME.matcher(name).matches()) {
      throw new BadInput(
          BadInput.quote(name)
              + (": expected a name of a-z and 0-9, with single dashes between, at most %s long, such"
                      + " as my-robots")
                  .formatted(LONGEST_NAME));
    }
    if (RESERVED.contains(ProjectTemplate.packageName(name))) {
      throw new BadInput(
          BadInput.quote(name) + ": is a reserved word; expected a name such as my-robots");
    }
    if (apps.contains(name)) {
      throw new BadInput(
          BadInput.quote(name) + ": an app or a primitive has this name; expected another name");
    }
  }

  /** Writes all files or none: into a temporary folder beside, which is then renamed. */
  private static void write(Path project, String shown, Map<String, ProjectTemplate.Written> files)
      throws IOException {
    if (Files.exists(project, LinkOption.NOFOLLOW_LINKS) && !isEmptyFolder(project)) {
      throw new BadInput(BadInput.quote(shown) + ": exists already; expected a new folder");
    }
    Path parent = Objects.requireNonNull(project.getParent());
    if (!Files.isDirectory(parent) || !Files.isWritable(parent)) {
      throw new BadInput(parent + ": expected a writable folder");
    }
    Path part = Files.createTempDirectory(parent, "." + project.getFileName() + ".part");
    try {
      for (Map.Entry<String, ProjectTemplate.Written> file : files.entrySet()) {
        write(part.resolve(file.getKey()), file.getValue());
      }
      if (isPosix(part)) {
        Files.setPosixFilePermissions(part, PosixFilePermissions.fromString("rwxr-xr-x"));
      }
      Files.move(part, project, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      delete(part);
      throw new IOException(
          BadInput.quote(shown) + ": cannot be written (" + FailureText.of(e) + ")", e);
    }
  }

  private static void write(Path path, ProjectTemplate.Written file) throws IOException {
    Files.createDirectories(Objects.requireNonNull(path.getParent()));
    Files.writeString(path, file.text());
    if (file.isProgram() && isPosix(path)) {
      Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
  }

  private static boolean isPosix(Path path) throws IOException {
    return Files.getFileStore(path).supportsFileAttributeView("posix");
  }

  private static boolean isEmptyFolder(Path path) throws IOException {
    if (!Files.isDirectory(path, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    try (Stream<Path> children = Files.list(path)) {
      return children.findAny().isEmpty();
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }
}
