package org.starl.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;

/**
 * What one of the two builds says, in words that they share.
 *
 * @param coordinates group and version of the project itself
 * @param javaRelease what javac's {@code --release} is
 * @param versions of libraries, by the name that the build gives the version
 */
record Build(
    String coordinates,
    String javaRelease,
    SortedSet<String> modules,
    SortedMap<String, String> versions,
    List<Dependency> dependencies) {

  /** The module without code: the versions of all others. */
  static final String BOM = "starl-bom";

  /** Every difference, one line each; none if the builds agree. */
  static List<String> differences(Build maven, Build gradle) {
    List<String> found = new ArrayList<>();
    compare(found, "group and version", maven.coordinates, gradle.coordinates);
    compare(found, "Java release", maven.javaRelease, gradle.javaRelease);
    compare(found, "modules", maven.modules, gradle.modules);
    for (Map.Entry<String, String> version : gradle.versions.entrySet()) {
      String other = maven.versions.get(version.getKey());
      compare(found, "version " + version.getKey(), other, version.getValue());
    }
    for (Dependency dependency : maven.dependencies) {
      if (!gradle.dependencies.contains(dependency)) {
        found.add("Maven alone has " + dependency);
      }
    }
    for (Dependency dependency : gradle.dependencies) {
      if (!maven.dependencies.contains(dependency)) {
        found.add("Gradle alone has " + dependency);
      }
    }
    return found;
  }

  private static void compare(List<String> found, String what, Object maven, Object gradle) {
    if (!gradle.equals(maven)) {
      found.add(what + ": Maven has " + maven + ", Gradle " + gradle);
    }
  }
}
