package org.starl.apps.lightpaint.view;

import java.io.ByteArrayInputStream;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;

/**
 * Checks that an SVG file can be read, and names file and line if not. A browser draws a broken
 * path up to the error, and so does JSVG; a robot must not.
 */
final class SvgCheck {

  // Possessive: a number is never split in two to make a pattern match.
  private static final String NUMBER =
      "[+-]?+(?:[0-9]++\\.?+[0-9]*+|\\.[0-9]++)(?:[eE][+-]?+[0-9]++)?+";

  private static final Pattern LENGTH =
      Pattern.compile("\\s*" + NUMBER + "(?:px|pt|pc|mm|cm|in|em|ex|rem|%)?\\s*");

  private static final Pattern BLANKS = Pattern.compile("[\\s,]*+");
  private static final Pattern NEXT_NUMBER = Pattern.compile("[\\s,]*+" + NUMBER);
  private static final Pattern NEXT_FLAG = Pattern.compile("[\\s,]*+[01]");

  /** The arguments of each command of a path, which may be repeated: n for number, f for flag. */
  private static final Map<Character, String> COMMANDS =
      Map.of(
          'M', "nn", 'L', "nn", 'T', "nn", 'H', "n", 'V', "n", 'C', "nnnnnn", 'S', "nnnn", 'Q',
          "nnnn", 'A', "nnnffnn", 'Z', "");

  private static final List<String> SHAPES =
      List.of("line", "rect", "circle", "ellipse", "svg", "use");
  private static final List<String> LENGTHS =
      List.of("x1", "y1", "x2", "y2", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry");

  private final String file;
  private final XMLStreamReader xml;

  private SvgCheck(String file, XMLStreamReader xml) {
    this.file = file;
    this.xml = xml;
  }

  /**
   * @throws BadInput if the file is no SVG, or a length, list of points or path cannot be read
   */
  static void check(String file, byte[] bytes) {
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    try {
      XMLStreamReader xml = factory.createXMLStreamReader(new ByteArrayInputStream(bytes));
      new SvgCheck(file, xml).elements();
    } catch (XMLStreamException e) {
      int line = e.getLocation() == null ? 1 : Math.max(1, e.getLocation().getLineNumber());
      List<String> message = String.valueOf(e.getMessage()).lines().toList();
      String why = message.get(message.size() - 1).replaceFirst("^Message: ", "");
      throw new BadInput(file + ":" + line + ": is not XML (" + why + "): expected an SVG drawing");
    }
  }

  private void elements() throws XMLStreamException {
    boolean isRoot = true;
    while (xml.hasNext()) {
      if (xml.next() == XMLStreamConstants.START_ELEMENT) {
        if (isRoot && !xml.getLocalName().equals("svg")) {
          throw bad("<" + xml.getLocalName() + ">", "<svg>, of an SVG drawing");
        }
        isRoot = false;
        element(xml.getLocalName());
      }
    }
  }

  private void element(String name) {
    for (String attribute : SHAPES.contains(name) ? LENGTHS : List.<String>of()) {
      String value = xml.getAttributeValue(null, attribute);
      if (value != null && !value.equals("auto") && !LENGTH.matcher(value).matches()) {
        throw bad(attribute + "=" + BadInput.quote(value), "a length, such as 12.5");
      }
    }
    checkNumbers("points", xml.getAttributeValue(null, "points"), "nn");
    if (name.equals("path")) {
      checkNumbers("path", xml.getAttributeValue(null, "d"), "");
    }
  }

  /**
   * Checks a list of points or a path.
   *
   * @param repeated arguments of a list; empty for a path, whose commands have their own
   */
  private void checkNumbers(String what, @Nullable String text, String repeated) {
    if (text == null) {
      return;
    }
    boolean isPath = repeated.isEmpty();
    String arguments = repeated;
    int start = end(BLANKS, text, 0);
    for (int at = start; at < text.length(); at = end(BLANKS, text, at)) {
      char command = Character.toUpperCase(text.charAt(at));
      if (isPath && at == start && command != 'M') {
        throw bad(what, text, at, "M first");
      }
      if (isPath && (Character.isLetter(command) || arguments.isEmpty())) {
        if (!COMMANDS.containsKey(command)) {
          throw bad(what, text, at, "a command: M L H V C S Q T A or Z");
        }
        arguments = COMMANDS.getOrDefault(command, "");
        at++;
      }
      for (int i = 0; i < arguments.length(); i++) {
        boolean isFlag = arguments.charAt(i) == 'f';
        int next = end(isFlag ? NEXT_FLAG : NEXT_NUMBER, text, at);
        if (next < 0) {
          String number = isPath ? "a number" : "numbers in pairs, such as 0,0 10,5";
          throw bad(what, text, at, isFlag ? "a flag of an arc, 0 or 1" : number);
        }
        at = next;
      }
    }
  }

  /** Where a match of {@code pattern} ends that begins at {@code from}; -1 if there is none. */
  private static int end(Pattern pattern, String text, int from) {
    Matcher matcher = pattern.matcher(text).region(from, text.length());
    return matcher.lookingAt() ? matcher.end() : -1;
  }

  private BadInput bad(String what, String text, int at, String expected) {
    String rest = text.substring(at, Math.min(at + 20, text.length()));
    return bad(what + ", character " + (at + 1) + ", at " + BadInput.quote(rest), expected);
  }

  private BadInput bad(String problem, String expected) {
    int line = xml.getLocation().getLineNumber();
    return new BadInput(file + ":" + line + ": " + problem + ": expected " + expected);
  }
}
