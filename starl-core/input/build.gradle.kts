plugins {
    `java-library`
    id("maven-publish")
}

description = "Reads what people write: quantities, text files"

dependencies {
    api(libs.jspecify)
    implementation(libs.jackson.core)
    implementation(libs.jackson.dataformat.yaml)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

configurations.configureEach {
    // The YAML parser alone is used, and a phone gets no data binding.
    exclude(mapOf("group" to "com.fasterxml.jackson.core", "module" to "jackson-databind"))
}
