package org.starl.input;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads a whole file that a user has named. An error ends with the expected kind of file. */
public final class TextFile {

  /** More than any input of StarL needs. */
  private static final int MAX_BYTES = 64 << 20;

  private static final int CHUNK_BYTES = 1 << 16;

  private TextFile() {}

  /**
   * Its text in UTF-8, without a byte order mark.
   *
   * @param expected the end of errors: {@code expected a scenario file}
   * @throws BadInput if it is missing, not a regular file, unreadable or not text
   */
  public static String read(Path file, String expected) {
    return decode(file.toString(), bytes(file, expected), expected);
  }

  /**
   * A stream of its bytes, for a file that is read in parts. Devices and pipes are refused: they may
   * have no end, or keep their reader waiting for ever.
   *
   * @throws BadInput if it is missing, not a regular file, or unreadable
   */
  public static InputStream open(Path file, String expected) {
    if (Files.isDirectory(file)) {
      throw new BadInput(file + ": is a folder; " + expected);
    }
    if (!Files.exists(file)) {
      throw new BadInput(file + ": no such file; " + expected);
    }
    if (!Files.isRegularFile(file)) {
      throw new BadInput(file + ": is not a regular file; " + expected);
    }
    try {
      return Files.newInputStream(file);
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + FailureText.of(e) + "); " + expected);
    }
  }

  /**
   * Its bytes.
   *
   * @throws BadInput if it is missing, not a regular file, unreadable or longer than 64 MiB
   */
  public static byte[] bytes(Path file, String expected) {
    try (InputStream in = open(file, expected)) {
      ByteArrayOutputStream all = all(in);
      if (all.size() > MAX_BYTES) {
        throw new BadInput(file + ": is longer than " + MAX_BYTES + " bytes; " + expected);
      }
      return all.toByteArray();
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + FailureText.of(e) + "); " + expected);
    }
  }

  /**
   * The text of one of the program's own files, which stands beside a class.
   *
   * @throws IllegalStateException if there is none
   */
  public static String resource(Class<?> type, String name) {
    try (InputStream in = type.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("no resource " + name + " beside " + type.getName());
      }
      return new String(all(in).toByteArray(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The bytes up to the end, or some more than {@link #MAX_BYTES}. */
  private static ByteArrayOutputStream all(InputStream in) throws IOException {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    byte[] chunk = new byte[CHUNK_BYTES];
    for (int read = in.read(chunk); read >= 0 && all.size() <= MAX_BYTES; read = in.read(chunk)) {
      all.write(chunk, 0, read);
    }
    return all;
  }

  /**
   * The text in the bytes of {@code file}, without a byte order mark.
   *
   * @throws BadInput if they are not UTF-8, or hold a zero
   */
  public static String decode(String file, byte[] bytes, String expected) {
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      if (text.indexOf('\0') < 0) {
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
      }
    } catch (CharacterCodingException e) {
      throw new BadInput(file + ": is not text; " + expected);
    }
    throw new BadInput(file + ": is not text; " + expected);
  }
}
