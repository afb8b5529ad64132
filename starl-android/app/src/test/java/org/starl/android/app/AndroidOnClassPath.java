package org.starl.android.app;

import java.io.File;
import java.net.MalformedURLException;
import java.net.URL;
import org.robolectric.internal.dependency.DependencyJar;
import org.robolectric.internal.dependency.DependencyResolver;

/**
 * Gives Robolectric the Android that is compiled with, from the class path, in place of one that it
 * would fetch itself while tests run. Found as a service.
 */
public final class AndroidOnClassPath implements DependencyResolver {

  @Override
  public URL getLocalArtifactUrl(DependencyJar jar) {
    String name = jar.getArtifactId() + "-" + jar.getVersion() + ".jar";
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      File file = new File(entry);
      if (file.getName().equals(name)) {
        try {
          return file.toURI().toURL();
        } catch (MalformedURLException e) {
          throw new IllegalStateException(e);
        }
      }
    }
    throw new IllegalStateException(
        name
            + " is not on the class path: does the test ask for another level than that of Android"
            + " 17, or lack -Drobolectric.usePreinstrumentedJars=false?");
  }
}
