package org.starl.cli.campaign;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.starl.cli.command.Digest;
import org.starl.cli.command.OutputFile;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;

/**
 * The rows of seeds that went well, in a file of a folder. Equal classes, settings, input files and Java
 * give equal runs, so they need not run again. The file's name has a digest of all four: a change of one
 * byte begins another file, and the old ones of the app are removed.
 */
final class GoodSeeds {

  private final Path folder;
  private final String app;
  private final Path file;
  private final SortedMap<Long, SeedRow> rows = new TreeMap<>();

  private GoodSeeds(Path folder, String app, Path file) {
    this.folder = folder;
    this.app = app;
    this.file = file;
  }

  /**
   * The seeds of this work that an earlier command saved.
   *
   * @param name of the work, part of a file's name
   * @param classes {@link #classes()}
   */
  static GoodSeeds of(Path folder, String name, SeedWork work, String classes) throws IOException {
    List<String> inputs =
        ShardHeader.settings(work.points().getFirst()).values().stream()
            .filter(GoodSeeds::isFile)
            .sorted()
            .toList();
    String digest = work.keys().getFirst() + "-" + Digest.of(classes, inputs);
    GoodSeeds seeds = new GoodSeeds(folder, name, folder.resolve(name + "-" + digest + ".rows"));
    if (Files.exists(seeds.file)) {
      int number = 0;
      for (String line : Files.readAllLines(seeds.file)) {
        number++;
        SeedRow row = work.row(seeds.file + ":" + number + ": ", line);
        seeds.rows.put(row.seed(), row);
      }
    }
    return seeds;
  }

  /** The saved rows by seed. */
  SortedMap<Long, SeedRow> rows() {
    return rows;
  }

  /** Adds a good run. */
  void add(SeedRow row) {
    rows.put(row.seed(), row);
  }

  /** Replaces the app's files. */
  void save() throws IOException {
    try (OutputFile output = new OutputFile("--out", file.toString())) {
      for (SeedRow row : rows.values()) {
        output.stream().write((row.line() + "\n").getBytes(StandardCharsets.UTF_8));
      }
    }
    removeOthers(folder, app, "-[0-9a-f]+-[0-9a-f]+\\.rows", file);
  }

  /**
   * Removes the files of an app from a folder.
   *
   * @param rest a regular expression of their names after the app's
   * @param kept is not removed; null for none
   */
  static void removeOthers(Path folder, String app, String rest, @Nullable Path kept)
      throws IOException {
    Pattern names = Pattern.compile(Pattern.quote(app) + rest);
    try (Stream<Path> files = Files.list(folder)) {
      for (Path old : files.toList()) {
        boolean isOfApp = names.matcher(String.valueOf(old.getFileName())).matches();
        if (isOfApp && !old.equals(kept)) {
          Files.delete(old);
        }
      }
    }
  }

  /**
   * A digest of all classes and files of the class path, and of Java's version.
   *
   * @throws BadInput if one cannot be read
   */
  static String classes() {
    String separator = Pattern.quote(System.getProperty("path.separator"));
    String path = System.getProperty("java.class.path");
    return Digest.of(Runtime.version().toString(), List.of(path.split(separator, -1)));
  }

  private static boolean isFile(String value) {
    try {
      return !value.isBlank() && Files.exists(Path.of(value));
    } catch (InvalidPathException e) {
      return false; // another kind of value
    }
  }
}
