package org.starl.sim.world;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.starl.input.BadInput;

/** Reads a whole file of text that a user has named. */
final class TextFile {

  private TextFile() {}

  /**
   * Its text, without a byte order mark.
   *
   * @param expected what it should have been, for errors
   * @throws BadInput if it is missing, a folder, unreadable or no text
   */
  static String read(Path path, String expected) {
    if (Files.isDirectory(path)) {
      throw new BadInput(path + ": is a folder; " + expected);
    }
    if (!Files.exists(path)) {
      throw new BadInput(path + ": no such file; " + expected);
    }
    try {
      byte[] bytes = Files.readAllBytes(path);
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      if (text.indexOf('\0') < 0) {
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
      }
    } catch (CharacterCodingException noText) {
      throw new BadInput(path + ": is no text; " + expected);
    } catch (IOException unreadable) {
      throw new BadInput(path + ": cannot be read (" + unreadable + "); " + expected);
    }
    throw new BadInput(path + ": is no text; " + expected);
  }
}
