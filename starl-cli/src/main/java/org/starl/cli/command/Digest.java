package org.starl.cli.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;
import org.starl.input.BadInput;

/** Short texts that differ where what they are made from differs: texts and files. */
public final class Digest {

  private static final int BYTES = 10;

  private Digest() {}

  /**
   * The digest of a text, and of the files and the folders' files at these paths.
   *
   * @throws BadInput if one cannot be read
   */
  public static String of(String text, List<String> paths) {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      digest.update(text.getBytes(StandardCharsets.UTF_8));
      for (String path : paths) {
        for (Path file : files(Path.of(path))) {
          digest.update(Path.of(path).relativize(file).toString().getBytes(StandardCharsets.UTF_8));
          digest.update(Files.readAllBytes(file));
        }
      }
      return HexFormat.of().formatHex(digest.digest(), 0, BYTES);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    } catch (IOException | UncheckedIOException e) {
      throw new BadInput("a file of the class path or of a setting: " + e.getMessage());
    }
  }

  /** The regular files below an entry of the class path, in order. */
  private static List<Path> files(Path entry) throws IOException {
    if (!Files.isDirectory(entry)) {
      return Files.isRegularFile(entry) ? List.of(entry) : List.of();
    }
    List<Path> files = new ArrayList<>();
    try (Stream<Path> all = Files.walk(entry)) {
      all.filter(Files::isRegularFile).sorted().forEach(files::add);
    }
    return files;
  }
}
