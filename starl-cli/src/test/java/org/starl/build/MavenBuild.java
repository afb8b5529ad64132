package org.starl.build;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/** Reads the poms: as much of Maven's model as they use, and no more. */
final class MavenBuild {

  private static final Pattern PROPERTY = Pattern.compile("\\$\\{([^}]+)}");

  private final Element parent;
  private final SortedMap<String, String> properties = new TreeMap<>();
  private final SortedMap<String, String> managed = new TreeMap<>();

  private MavenBuild(Element parent) {
    this.parent = parent;
    properties.put("project.version", childText(parent, "version"));
    for (Element property : children(child(parent, "properties"))) {
      properties.put(property.getTagName(), property.getTextContent().strip());
    }
    Element management = child(parent, "dependencyManagement");
    for (Element dependency : children(child(management, "dependencies"))) {
      managed.put(nameOf(dependency), resolve(childText(dependency, "version")));
    }
  }

  /**
   * @param files gives the text of a file of the project
   */
  static Build read(UnaryOperator<String> files) {
    return new MavenBuild(parse("pom.xml", files.apply("pom.xml"))).build(files);
  }

  private Build build(UnaryOperator<String> files) {
    TreeSet<String> modules = new TreeSet<>();
    List<Dependency> dependencies = new ArrayList<>();
    for (Element module : modules()) {
      String name = module.getTextContent().strip();
      modules.add(name);
      if (name.equals(Build.BOM)) {
        continue;
      }
      String path = name + "/pom.xml";
      addDependencies(dependencies, name, parent);
      addDependencies(dependencies, name, parse(path, files.apply(path)));
    }
    SortedMap<String, String> versions = new TreeMap<>();
    for (String property : properties.keySet()) {
      if (property.endsWith(".version")) {
        versions.put(property.replaceAll("\\.version$", ""), properties.get(property));
      }
    }
    String coordinates = childText(parent, "groupId") + ":" + childText(parent, "version");
    String release = resolve("${maven.compiler.release}");
    return new Build(coordinates, release, modules, versions, dependencies);
  }

  /** Those of every build, and those of profiles. */
  private List<Element> modules() {
    List<Element> found = new ArrayList<>(children(child(parent, "modules")));
    for (Element profile : children(child(parent, "profiles"))) {
      for (Element part : children(profile)) {
        if (part.getTagName().equals("modules")) {
          found.addAll(children(part));
        }
      }
    }
    return found;
  }

  private void addDependencies(List<Dependency> found, String module, Element pom) {
    for (Element section : children(pom)) {
      if (section.getTagName().equals("dependencies")) {
        for (Element dependency : children(section)) {
          found.add(dependency(module, dependency));
        }
      }
    }
  }

  private Dependency dependency(String module, Element element) {
    String name = nameOf(element);
    String type = "";
    String version = null;
    String scope = "compile";
    for (Element part : children(element)) {
      String text = resolve(part.getTextContent().strip());
      switch (part.getTagName()) {
        case "groupId", "artifactId" -> {}
        case "version" -> version = text;
        case "scope" -> scope = text;
        case "type" -> type = "@" + text;
        default -> throw new IllegalStateException(module + ", " + name + ": " + part.getTagName());
      }
    }
    if (version == null) {
      version = managed.get(name);
    }
    if (version == null) {
      throw new IllegalStateException(module + " needs " + name + " without a version");
    }
    return new Dependency(module, name + type, version, scope);
  }

  private static String nameOf(Element dependency) {
    return childText(dependency, "groupId") + ":" + childText(dependency, "artifactId");
  }

  private String resolve(String text) {
    Matcher matcher = PROPERTY.matcher(text);
    return matcher.replaceAll(match -> {
      String value = properties.get(match.group(1));
      if (value == null) {
        throw new IllegalStateException("pom.xml does not define " + match.group());
      }
      return Matcher.quoteReplacement(resolve(value));
    });
  }

  private static Element parse(String path, String text) {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(new InputSource(new StringReader(text)))
          .getDocumentElement();
    } catch (ParserConfigurationException | SAXException | IOException e) {
      throw new IllegalStateException(path, e);
    }
  }

  private static String childText(Element element, String name) {
    return child(element, name).getTextContent().strip();
  }

  private static Element child(Element element, String name) {
    return children(element).stream()
        .filter(child -> child.getTagName().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalStateException(element.getTagName() + " has no " + name));
  }

  private static List<Element> children(Element element) {
    List<Element> found = new ArrayList<>();
    for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element child) {
        found.add(child);
      }
    }
    return found;
  }
}
