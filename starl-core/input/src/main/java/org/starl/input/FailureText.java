package org.starl.input;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.ServiceConfigurationError;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.reader.ReaderException;

/** The failures of libraries and of the system in StarL's words: no class name and no hint for programmers. */
public final class FailureText {

  /** The class, or the line, that {@link java.util.ServiceLoader} names. */
  private static final Pattern ENTRY =
      Pattern.compile("\\S+(?= not found| not a subtype| could not| Unable)|(?<=name: ).*");

  private FailureText() {}

  /** Why a file or a connection failed, as a part of a message: {@code No space left on device}. */
  public static String of(Exception failure) {
    if (failure instanceof NoSuchFileException) {
      return "no such file or folder";
    }
    if (failure instanceof AccessDeniedException) {
      return "no permission";
    }
    if (failure instanceof CharacterCodingException) {
      return "not text in UTF-8";
    }
    if (failure instanceof FileAlreadyExistsException there) {
      return BadInput.quote(there.getFile()) + " is a file already";
    }
    boolean hasReason = failure instanceof FileSystemException named && named.getReason() != null;
    String text = hasReason ? ((FileSystemException) failure).getReason() : failure.getMessage();
    return text == null ? "it failed" : text;
  }

  /** The same with the file's name before it, unless it is there. */
  public static String of(String file, Exception failure) {
    String text = of(failure);
    return text.startsWith(file) ? text : file + ": " + text;
  }

  /** An entry of {@code META-INF/services} on the class path that gives no object. */
  public static BadInput service(Class<?> service, ServiceConfigurationError failure) {
    Matcher entry = ENTRY.matcher(String.valueOf(failure.getMessage()));
    String name = entry.find() ? BadInput.quote(entry.group()) : "one of its lines";
    String why = failure.getCause() == null ? "" : ", which fails with " + failure.getCause();
    return new BadInput(
        "META-INF/services/"
            + service.getName()
            + ": "
            + name
            + why
            + ": expected the name of a public class that is a "
            + service.getSimpleName()
            + ", with a public constructor without parameters");
  }

  /**
   * The error of a parser of YAML or JSON.
   *
   * @param text which it read
   * @param language what the text is not
   * @param expected the end of the message
   */
  public static BadInput syntax(
      String file, String text, JsonProcessingException failure, String language, String expected) {
    JsonLocation place = failure.getLocation();
    int number = place == null ? 1 : Math.max(1, place.getLineNr());
    int column = place == null ? 1 : Math.max(1, place.getColumnNr());
    // Jackson's own place in YAML is the end of what it read before.
    if (failure.getCause() instanceof MarkedYAMLException yaml && yaml.getProblemMark() != null) {
      number = yaml.getProblemMark().getLine() + 1;
      column = yaml.getProblemMark().getColumn() + 1;
    }
    String[] lines = lines(text);
    if (failure.getCause() instanceof ReaderException character) {
      int end = text.offsetByCodePoints(0, character.getPosition());
      String[] before = lines(text.substring(0, end));
      number = before.length;
      column = before[number - 1].length() + 1;
    }
    String line = number <= lines.length ? lines[number - 1] : "";
    int at = Math.min(line.length(), column - 1);
    return BadInput.at(file, number, found(line, at, language) + "; " + expected);
  }

  private static String[] lines(String text) {
    return text.split("\r\n|\r|\n", -1);
  }

  /** What is wrong at this place of a line. */
  private static String found(String line, int at, String language) {
    boolean isYaml = language.equals("YAML");
    if (isYaml && line.matches("\\s*\t.*")) {
      return "begins with a tab: expected blanks to indent, as YAML has no tabs";
    }
    String where = "at character " + (at + 1);
    if (isYaml && line.startsWith("\t", at)) {
      return "has a tab "
          + where
          + ": expected blanks to separate words, as YAML has no tabs there";
    }
    String rest = line.substring(at).replaceAll("^\\s+|\\s+$", "");
    return "is not "
        + language
        + (rest.isEmpty() ? " at the end of this line" : " " + where + ", " + BadInput.quote(rest));
  }
}
