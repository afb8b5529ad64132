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
import org.starl.input.BadInput;

/**
 * Tells by file and line what in an SVG file cannot be read. A browser draws a broken path as far as
 * it understands it, and so does JSVG: a robot should not.
 */
final class SvgCheck {

  private static final String NUMBER = "[+-]?(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?";
  private static final Pattern LENGTH =
      Pattern.compile("\\s*" + NUMBER + "(?:px|pt|pc|mm|cm|in|em|ex|rem|%)?\\s*");
  private static final Pattern POINTS =
      Pattern.compile("[\\s,]*(?:" + NUMBER + "[\\s,]*" + NUMBER + "[\\s,]*)*");
  private static final Pattern NEXT = Pattern.compile("[\\s,]*(" + NUMBER + ")");
  private static final Pattern FLAG = Pattern.compile("[\\s,]*[01]");

  /** How many numbers each command of a path takes, repeated; flags of an arc are f. */
  private static final Map<Character, String> COMMANDS =
      Map.of(
          'M', "nn", 'L', "nn", 'T', "nn", 'H', "n", 'V', "n", 'C', "nnnnnn", 'S', "nnnn", 'Q',
          "nnnn", 'A', "nnnffnn", 'Z', "");

  private static final Map<String, List<String>> LENGTHS =
      Map.of(
          "line", List.of("x1", "y1", "x2", "y2"),
          "rect", List.of("x", "y", "width", "height", "rx", "ry"),
          "circle", List.of("cx", "cy", "r"),
          "ellipse", List.of("cx", "cy", "rx", "ry"),
          "svg", List.of("x", "y", "width", "height"),
          "use", List.of("x", "y", "width", "height"));

  private final String file;
  private final XMLStreamReader xml;

  private SvgCheck(String file, XMLStreamReader xml) {
    this.file = file;
    this.xml = xml;
  }

  static void check(String file, byte[] bytes) {
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    try {
      XMLStreamReader xml = factory.createXMLStreamReader(new ByteArrayInputStream(bytes));
      new SvgCheck(file, xml).all();
    } catch (XMLStreamException e) {
      int line = e.getLocation() == null ? 1 : Math.max(1, e.getLocation().getLineNumber());
      List<String> said = String.valueOf(e.getMessage()).lines().toList();
      String why = said.get(said.size() - 1).replaceFirst("^Message: ", "");
      throw new BadInput(file + ":" + line + ": is no XML (" + why + "): expected an SVG drawing");
    }
  }

  private void all() throws XMLStreamException {
    boolean isFirst = true;
    while (xml.hasNext()) {
      if (xml.next() == XMLStreamConstants.START_ELEMENT) {
        if (isFirst && !xml.getLocalName().equals("svg")) {
          throw new BadInput(
              place() + "<" + xml.getLocalName() + ">: expected <svg>, of an SVG drawing");
        }
        isFirst = false;
        element();
      }
    }
  }

  private void element() {
    String name = xml.getLocalName();
    for (String attribute : LENGTHS.getOrDefault(name, List.of())) {
      String value = xml.getAttributeValue(null, attribute);
      if (value != null && !value.equals("auto") && !LENGTH.matcher(value).matches()) {
        throw bad(attribute, value, "a length, such as 12.5");
      }
    }
    String points = xml.getAttributeValue(null, "points");
    if (points != null && !POINTS.matcher(points).matches()) {
      throw bad("points", points, "numbers in pairs, such as 0,0 10,5");
    }
    String d = name.equals("path") ? xml.getAttributeValue(null, "d") : null;
    if (d != null) {
      path(d);
    }
  }

  private void path(String d) {
    String numbers = "";
    boolean isFirst = true;
    int at = skipBlanks(d, 0, "\\s*");
    while (at < d.length()) {
      char command = Character.toUpperCase(d.charAt(at));
      String own = COMMANDS.get(command);
      if (own == null && (numbers.isEmpty() || Character.isLetter(command))) {
        throw badPath(d, at, "a command: M L H V C S Q T A or Z");
      }
      if (isFirst && command != 'M') {
        throw badPath(d, at, "M first");
      }
      isFirst = false;
      numbers = own == null ? numbers : own;
      at = numbers(d, own == null ? at : at + 1, numbers);
      at = skipBlanks(d, at, "[\\s,]*");
    }
  }

  private int numbers(String d, int from, String numbers) {
    int at = from;
    for (int i = 0; i < numbers.length(); i++) {
      boolean isFlag = numbers.charAt(i) == 'f';
      Matcher next = (isFlag ? FLAG : NEXT).matcher(d).region(at, d.length());
      if (!next.lookingAt()) {
        throw badPath(d, at, isFlag ? "a flag of an arc, 0 or 1" : "a number");
      }
      at = next.end();
    }
    return at;
  }

  private static int skipBlanks(String d, int at, String blanks) {
    Matcher matcher = Pattern.compile(blanks).matcher(d).region(at, d.length());
    return matcher.lookingAt() ? matcher.end() : at;
  }

  private BadInput badPath(String d, int at, String expected) {
    String rest = d.substring(Math.min(at, d.length()));
    return new BadInput(
        place()
            + "path, character "
            + (at + 1)
            + ", at "
            + BadInput.quote(rest.length() > 20 ? rest.substring(0, 20) : rest)
            + ": expected "
            + expected);
  }

  private BadInput bad(String attribute, String value, String expected) {
    return new BadInput(
        place() + attribute + "=" + BadInput.quote(value) + ": expected " + expected);
  }

  private String place() {
    return file + ":" + xml.getLocation().getLineNumber() + ": ";
  }
}
