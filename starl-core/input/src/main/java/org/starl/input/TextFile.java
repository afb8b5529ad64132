package org.starl.input;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;

/** A file that a person has written. */
public final class TextFile {

  private TextFile() {}

  /**
   * All of it, as text.
   *
   * @param what it should be, as in "a scenario file", and
   * @param expected what it should have in it, for messages
   * @throws BadInput if it is missing, a folder, or no text in UTF-8
   */
  public static String read(String file, String what, String expected) {
    return decode(file, bytes(file, what), expected);
  }

  /**
   * All of it.
   *
   * @param what it should be
   * @throws BadInput if it is missing, or a folder
   */
  public static byte[] bytes(String file, String what) {
    Path path = Paths.get(file);
    if (Files.isDirectory(path)) {
      throw new BadInput(file + ": is a folder; expected " + what);
    }
    if (!Files.exists(path)) {
      throw new BadInput(file + ": no such file; expected " + what);
    }
    try {
      return Files.readAllBytes(path);
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + e + ")");
    }
  }

  /**
   * The text in these bytes of {@code file}.
   *
   * @param expected what should be in it
   * @throws BadInput if it is none in UTF-8
   */
  public static String decode(String file, byte[] bytes, String expected) {
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      if (text.indexOf('\0') < 0) {
        return text;
      }
    } catch (CharacterCodingException e) {
      throw new BadInput(file + ": is no text; " + expected);
    }
    throw new BadInput(file + ": is no text; " + expected);
  }
}
