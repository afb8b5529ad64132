plugins {
    `java-library`
}

description = "Pages of live runs: the server of the command line"

dependencies {
    api(project(":starl-cli"))
    implementation(libs.javalin)
    // Jetty's log has no reader: what a person needs to know is told by errors.
    runtimeOnly(libs.slf4j.nop)
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

// The driver of a browser, which the pages of the viewer are tested with, too.
extensions.configure<JavaPluginExtension> {
    sourceSets.named("test") { java.srcDir("../../starl-sim/view/src/browser/java") }
}
