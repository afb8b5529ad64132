package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.File;
import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Classes with shapes refer to each other's constants: whichever is used first, all are there. */
@Tag("long")
class ShapesInAnyOrderTest {

  private static URL[] classPath() throws MalformedURLException {
    List<URL> urls = new ArrayList<>();
    for (String part : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      urls.add(Path.of(part).toUri().toURL());
    }
    return urls.toArray(URL[]::new);
  }

  private static boolean isShape(JavaField field) {
    String of = field.getRawType().getPackageName();
    return field.getModifiers().contains(JavaModifier.STATIC)
        && (of.equals("org.starl.shape") || of.equals("org.starl.trace"));
  }

  private static List<String> classesWithShapes() {
    return new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("/run/test-classes/"))
            .importPackages("org.starl")
            .stream()
            .filter(type -> type.getFields().stream().anyMatch(ShapesInAnyOrderTest::isShape))
            .map(JavaClass::getName)
            .sorted()
            .toList();
  }

  @Test
  void eachClassWithAShapeMayBeTheFirst() throws IOException {
    URL[] path = classPath();
    List<String> classes = classesWithShapes();
    List<String> broken = new ArrayList<>();
    for (String name : classes) {
      try (URLClassLoader fresh = new URLClassLoader(path, ClassLoader.getPlatformClassLoader())) {
        Class.forName(name, true, fresh);
      } catch (ExceptionInInitializerError | ClassNotFoundException e) {
        broken.add(name + ": " + e);
      }
    }
    assertThat(broken).isEmpty();
    assertThat(classes).hasSizeGreaterThan(50);
  }
}
