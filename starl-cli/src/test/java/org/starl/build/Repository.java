package org.starl.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;

/** The source tree around the running test, without what builds and tools put there. */
final class Repository {

  private static final Set<String> NOT_SOURCE =
      Set.of("target", "build", "out", "bin", "node_modules");
  private static final Set<String> HIDDEN_SOURCE = Set.of(".mvn", ".ci");
  private static final Set<String> TEXT =
      Set.of(
          "java",
          "kt",
          "kts",
          "xml",
          "toml",
          "properties",
          "md",
          "yaml",
          "yml",
          "json",
          "wpt",
          "pvs",
          "starl",
          "prf",
          "sh",
          "csv",
          "txt",
          "config");

  private final Path root;

  private Repository(Path root) {
    this.root = root;
  }

  /** The repository that holds the working directory. */
  static Repository here() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("settings.gradle.kts"))) {
      folder = folder.getParent();
      if (folder == null) {
        throw new IllegalStateException("no settings.gradle.kts in or above the working directory");
      }
    }
    return new Repository(folder);
  }

  String text(String path) {
    try {
      return Files.readString(root.resolve(path));
    } catch (IOException e) {
      throw new UncheckedIOException(path, e);
    }
  }

  /** The file at {@code path}. */
  Path file(String path) {
    return root.resolve(path);
  }

  boolean exists(String path) {
    return Files.exists(root.resolve(path));
  }

  /** Every text file of the project, as a path with slashes from its root, in order. */
  List<SourceFile> textFiles() {
    List<SourceFile> files = new ArrayList<>();
    for (String path : paths()) {
      if (isText(path)) {
        files.add(new SourceFile(path, text(path)));
      }
    }
    return files;
  }

  private static boolean isText(String path) {
    String name = path.substring(path.lastIndexOf('/') + 1);
    int dot = name.lastIndexOf('.');
    return path.equals("starl")
        || path.startsWith(".ci/")
        || (dot > 0 && TEXT.contains(name.substring(dot + 1)));
  }

  List<String> paths() {
    List<String> paths = new ArrayList<>();
    try {
      Files.walkFileTree(
          root,
          new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
              return folder.equals(root) || mayHoldSources(folder)
                  ? FileVisitResult.CONTINUE
                  : FileVisitResult.SKIP_SUBTREE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
              paths.add(root.relativize(file).toString().replace('\\', '/'));
              return FileVisitResult.CONTINUE;
            }
          });
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    Collections.sort(paths);
    return paths;
  }

  /** Also false for `build` the output folder, true for `build` the package. */
  private boolean mayHoldSources(Path folder) {
    String name = folder.getFileName().toString();
    if (name.startsWith(".")) {
      return HIDDEN_SOURCE.contains(name);
    }
    boolean isInSourceFolder = root.relativize(folder).toString().contains("src");
    return isInSourceFolder || !NOT_SOURCE.contains(name);
  }
}
