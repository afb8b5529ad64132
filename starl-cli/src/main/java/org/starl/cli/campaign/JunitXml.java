package org.starl.cli.campaign;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.starl.sim.check.RunOutcome.Verdict;

/**
 * The results of campaigns as JUnit XML, which every CI server shows: a suite for each app, a case for
 * each seed. It has no times, so equal campaigns give equal files.
 */
final class JunitXml {

  /**
   * One case.
   *
   * @param isError whether an exception ended the run
   * @param problem one line; empty for a good case
   * @param details what more to show of a bad case
   */
  private record Case(String name, boolean isError, String problem, String details) {}

  private final Map<String, List<Case>> suites = new LinkedHashMap<>();

  /** Adds a seed's run. */
  void add(String suite, long seed, Verdict verdict, String problem, List<String> details) {
    boolean isError = verdict == Verdict.FAILED;
    suite(suite).add(new Case("seed " + seed, isError, problem, String.join("\n", details)));
  }

  /** Adds a case that is not a seed's. */
  void add(String suite, String name, String problem) {
    suite(suite).add(new Case(name, false, problem, problem));
  }

  private List<Case> suite(String name) {
    return suites.computeIfAbsent(name, any -> new ArrayList<>());
  }

  void write(OutputStream out) throws IOException {
    try {
      XMLStreamWriter xml = XMLOutputFactory.newFactory().createXMLStreamWriter(out, "UTF-8");
      xml.writeStartDocument("UTF-8", "1.0");
      xml.writeCharacters("\n");
      xml.writeStartElement("testsuites");
      for (Map.Entry<String, List<Case>> suite : suites.entrySet()) {
        write(xml, suite.getKey(), suite.getValue());
      }
      xml.writeCharacters("\n");
      xml.writeEndElement();
      xml.writeCharacters("\n");
      xml.writeEndDocument();
      xml.flush();
    } catch (XMLStreamException e) {
      throw new IOException("JUnit XML: " + e.getMessage(), e);
    }
  }

  private static void write(XMLStreamWriter xml, String suite, List<Case> cases)
      throws XMLStreamException {
    xml.writeCharacters("\n");
    xml.writeStartElement("testsuite");
    xml.writeAttribute("name", suite);
    xml.writeAttribute("tests", Integer.toString(cases.size()));
    xml.writeAttribute("failures", count(cases, false));
    xml.writeAttribute("errors", count(cases, true));
    for (Case each : cases) {
      xml.writeCharacters("\n  ");
      xml.writeStartElement("testcase");
      xml.writeAttribute("classname", suite);
      xml.writeAttribute("name", each.name);
      if (!each.problem.isEmpty()) {
        xml.writeStartElement(each.isError ? "error" : "failure");
        xml.writeAttribute("message", printable(each.problem));
        xml.writeCharacters(printable(each.details));
        xml.writeEndElement();
      }
      xml.writeEndElement();
    }
    xml.writeCharacters("\n");
    xml.writeEndElement();
  }

  private static String count(List<Case> cases, boolean isError) {
    return Long.toString(
        cases.stream().filter(c -> !c.problem.isEmpty() && c.isError == isError).count());
  }

  /** XML 1.0 forbids other control characters. */
  private static String printable(String text) {
    return text.replaceAll(
        "[\\x00-\\x08\\x0B\\x0C\\x0E-\\x1F\\uFFFE\\uFFFF]|[\\uD800-\\uDFFF]", "?");
  }
}
